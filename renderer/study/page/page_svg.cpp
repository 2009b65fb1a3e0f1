// page_svg(): a chart in the page. Both places of each dot, on a logarithmic and on a linear axis, are worked out here;
// the script only moves dots between them.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/study/charts/label_places.h"
#include "renderer/study/page/html_text.h"
#include "renderer/study/page/page.h"

namespace gbl {
namespace {

// Units of the drawing: pixels when the page is as wide.
constexpr glm::dvec2 kFrame{858, 470}, kCorner{90, 36}, kWhole{960, 566};
constexpr double kDot = 5.5;
constexpr glm::dvec2 kLetter{8.6, 17};  // of a name beside a dot, on the average

// Disc, square, triangles, diamond, pentagon; seven colours stand in the style sheet: 42 families differ.
constexpr const char* kShapes[] = {"M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0z",
                                   "M-4.5-4.5h9v9h-9z",
                                   "M0-6L5.5 4H-5.5z",
                                   "M0 6L5.5-4H-5.5z",
                                   "M0-6.5L5.5 0L0 6.5L-5.5 0z",
                                   "M0-6L5.7-1.9L3.5 4.9H-3.5L-5.7-1.9z"};
constexpr size_t kColours = 7;

double across(const ChartAxis& axis, double value) { return kCorner.x + kFrame.x * axis.along(value); }
double down(const ChartAxis& axis, double value) { return kCorner.y + kFrame.y * (1 - axis.along(value)); }

glm::dvec2 place(const PageChart& c, const PagePoint& p) { return {across(c.x.shown, p.x), down(c.y.shown, p.y)}; }

// ---- axes -----------------------------------------------------------------------------------------------------------

std::string tick_across(double x, const std::string& label) {
  return fmt::format(R"(<path d="M{0:.1f} {1}v{2}"/><text x="{0:.1f}" y="{3}" text-anchor="middle">{4}</text>)", x,
                     kCorner.y, kFrame.y, kCorner.y + kFrame.y + 20, html_text(label));
}
std::string tick_down(double y, const std::string& label) {
  return fmt::format(R"(<path d="M{0} {1:.1f}h{2}"/><text x="{3}" y="{4:.1f}" text-anchor="end">{5}</text>)", kCorner.x,
                     y, kFrame.x, kCorner.x - 7, y + 5, html_text(label));
}

// Zero has a row of its own on a logarithmic axis, which knows none: a band, so that nobody takes it for the smallest value.
std::string zero_band(const ChartAxis& axis, bool is_x) {
  if (!axis.zero_at) return "";
  const double zero = is_x ? across(axis, 0) : down(axis, 0);
  return is_x ? fmt::format(R"(<rect class="zero" x="{:.1f}" y="{}" width="24" height="{}"/>)", zero - 12, kCorner.y,
                            kFrame.y)
              : fmt::format(R"(<rect class="zero" x="{}" y="{:.1f}" width="{}" height="24"/>)", kCorner.x, zero - 12,
                            kFrame.x);
}

std::string ticks(const ChartAxis& axis, bool is_x, int way) {
  std::string text = fmt::format(R"(<g class="ticks" data-axis="{}" data-way="{}"{}>)", is_x ? "x" : "y", way,
                                 way == 0 ? "" : " display=\"none\"");
  text += zero_band(axis, is_x);
  for (const ChartTick& t : ticks_of(axis))
    text += is_x ? tick_across(across(axis, t.at), t.label) : tick_down(down(axis, t.at), t.label);
  return text + "</g>\n";
}

std::string axes(const PageChart& c) {
  std::string text = ticks(c.x.shown, true, 0) + ticks(c.y.shown, false, 0);
  if (c.x.other) text += ticks(*c.x.other, true, 1);
  if (c.y.other) text += ticks(*c.y.other, false, 1);
  text += fmt::format(R"(<rect class="frame" x="{}" y="{}" width="{}" height="{}"/>)", kCorner.x, kCorner.y, kFrame.x,
                      kFrame.y);
  text += fmt::format(R"(<text class="title" x="{}" y="{}" text-anchor="end">{} &#8594;</text>)", kCorner.x + kFrame.x,
                      kWhole.y - 12, html_text(c.x.title));
  return text + fmt::format("<text class=\"title\" x=\"4\" y=\"18\">&#8593; {}</text>\n", html_text(c.y.title));
}

// ---- lines ----------------------------------------------------------------------------------------------------------

std::string polyline(const std::vector<glm::dvec2>& places, const std::string& attributes) {
  if (places.empty()) return "";
  std::string points;
  for (const glm::dvec2& p : places) points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", p.x, p.y);
  return fmt::format("<polyline {} points=\"{}\"/>\n", attributes, points);
}

// What a budget buys: a staircase up to the right edge.
std::string front_line(const PageChart& c) {
  std::vector<glm::dvec2> corners;
  std::vector<const PagePoint*> front;
  for (const PagePoint& p : c.points)
    if (p.on_front) front.push_back(&p);
  std::stable_sort(front.begin(), front.end(), [](const auto* a, const auto* b) { return a->x < b->x; });
  for (const PagePoint* p : front) {
    const glm::dvec2 at = place(c, *p);
    if (!corners.empty()) corners.push_back({at.x, corners.back().y});
    corners.push_back(at);
  }
  if (!corners.empty()) corners.push_back({kCorner.x + kFrame.x, corners.back().y});
  return polyline(corners, "class=\"front\"");
}

std::string family_lines(const PageChart& c) {
  std::string text;
  for (size_t family = 0; family < c.families.size(); ++family) {
    std::vector<glm::dvec2> places;
    for (const PagePoint& p : c.points)
      if (p.family == family) places.push_back(place(c, p));
    text += polyline(places, fmt::format(R"(class="line f{}" data-family="{}")", family % kColours, family));
  }
  return text;
}

// ---- dots -----------------------------------------------------------------------------------------------------------

std::string dot(const PageChart& c, const PagePoint& p) {
  const glm::dvec2 at = place(c, p);
  const double x_other = c.x.other ? across(*c.x.other, p.x) : at.x, y_other = c.y.other ? down(*c.y.other, p.y) : at.y;
  std::string text = fmt::format(
      R"-(<g class="dot f{}{}{}" role="img" tabindex="-1" data-family="{}" data-x="{:.1f} {:.1f}" data-y="{:.1f} {:.1f}"{} transform="translate({:.1f} {:.1f})">)-",
      p.family % kColours, p.sound ? "" : " unsound", p.on_front ? " on-front" : "", p.family, at.x, x_other, at.y,
      y_other, p.row ? fmt::format(" data-row=\"{}\"", *p.row) : "", at.x, at.y);
  text += "<title>" + html_text(p.words) + "</title>";
  if (p.marked) text += R"(<circle class="ring" r="9"/>)";
  text += fmt::format("<path d=\"{}\"/>", kShapes[p.family % std::size(kShapes)]);
  if (p.noisy) text += R"(<path class="noisy" d="M-8-8L8 8M-8 8L8-8"/>)";
  return text + "</g>\n";
}

// UTF-8: what continues a letter is none.
double letters(const std::string& text) {
  return static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string label(const PagePoint& p, const PlacedLabel& l, glm::dvec2 from) {
  const glm::dvec2 at = l.box.middle() + kCorner;
  std::string text = R"(<g class="label">)";
  if (l.line_to)
    text += fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", from.x, from.y, l.line_to->x + kCorner.x,
                        l.line_to->y + kCorner.y);
  return text + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text></g>\n", at.x, at.y + 5,
                            html_text(p.label));
}

std::string labels(const PageChart& c) {
  std::vector<ChartMark> marks;
  std::vector<LabelWish> wishes;
  std::vector<const PagePoint*> named;
  for (const PagePoint& p : c.points) {
    const double radius = p.marked ? 9 : kDot;
    marks.push_back({place(c, p) - kCorner, radius});
    if (p.label.empty()) continue;
    wishes.push_back({place(c, p) - kCorner, radius, kLetter * glm::dvec2(letters(p.label), 1)});
    named.push_back(&p);
  }
  const std::vector<std::optional<PlacedLabel>> places = place_labels(kFrame, marks, wishes);
  std::string text;
  for (size_t i = 0; i < named.size(); ++i)
    if (places[i]) text += label(*named[i], *places[i], place(c, *named[i]));
  return text;
}

// ---- the legend -----------------------------------------------------------------------------------------------------

std::string swatch(size_t family, bool sound) {
  return fmt::format(
      R"(<svg class="swatch" viewBox="-8 -8 16 16" aria-hidden="true"><g class="dot f{}{}"><path d="{}"/></g></svg>)",
      family % kColours, sound ? "" : " unsound", kShapes[family % std::size(kShapes)]);
}

bool has(const PageChart& c, size_t family, bool sound) {
  return std::any_of(c.points.begin(), c.points.end(),
                     [&](const PagePoint& p) { return p.family == family && p.sound == sound; });
}

std::string control(const std::string& attributes, const std::string& words) {
  return fmt::format("<li><label><input class=\"js\" type=\"checkbox\" {}>{}</label></li>\n", attributes, words);
}

std::string axis_control(const PageAxis& axis, const char* name, const char* words) {
  if (!axis.other) return "";
  return control(fmt::format(R"(data-log="{}"{})", name, axis.shown.logarithmic ? " data-first=\"1\" checked" : ""),
                 words);
}

// Sound: filled; unsound: open. A family has both where its set-ups differ in other choices.
std::string legend(const PageChart& c) {
  std::string text = "<div class=\"legends\"><ul class=\"legend\">\n";
  for (const bool sound : {true, false}) {
    std::string families;
    for (size_t f = 0; f < c.families.size(); ++f)
      if (has(c, f, sound))
        families += control(fmt::format(R"(checked data-family="{}" data-sound="{}")", f, sound ? 1 : 0),
                            swatch(f, sound) + html_text(c.families[f].empty() ? "other" : c.families[f]));
    if (!families.empty())
      text += fmt::format("<li class=\"group\">{}</li>\n{}",
                          sound ? "Sound (filled)" : "Unsound: a known failure (open)", families);
  }
  text += "</ul>\n<ul class=\"legend\">\n";
  if (!c.front.empty())
    text += control(
        "checked data-front=\"1\"",
        R"(<svg class="swatch" viewBox="-8 -8 16 16" aria-hidden="true"><path class="front" d="M-8 0h16"/></svg>)" +
            html_text(c.front));
  if (!c.marked.empty())
    text +=
        fmt::format(
            R"(<li><svg class="swatch" viewBox="-10 -10 20 20" aria-hidden="true"><circle class="ring" r="9"/></svg>{}</li>)",
            html_text(c.marked)) +
        "\n";
  text += axis_control(c.x, "x", "logarithmic to the right") + axis_control(c.y, "y", "logarithmic upwards");
  return text + "</ul></div>\n";
}

}  // namespace

PageAxis page_axis(const StudyColumn& column, const std::vector<double>& values) {
  StudyColumn turned = column;
  turned.more_is_better = !column.more_is_better;  // what makes an axis linear
  PageAxis axis{axis_title(column), axis_for(column, values), axis_for(turned, values)};
  const bool negative = std::any_of(values.begin(), values.end(), [](double v) { return v < 0; });
  if (negative && axis.shown.logarithmic) axis.shown = *axis.other;
  if (negative) axis.other.reset();
  return axis;
}

std::string page_svg(const PageChart& c, size_t number) {
  std::string text = fmt::format(
      "<figure class=\"chart\" id=\"chart{0}\">\n<figcaption><h2>{1}</h2><p>{2}</p></figcaption>\n"
      "<div class=\"drawing\"><svg viewBox=\"0 0 {3} {4}\" role=\"group\" aria-label=\"{1}\" tabindex=\"0\">\n",
      number, html_text(c.title), html_text(c.note), kWhole.x, kWhole.y);
  text += axes(c) + (c.front.empty() ? "" : front_line(c)) + (c.joined ? family_lines(c) : "");
  for (const PagePoint& p : c.points) text += dot(c, p);
  return text + labels(c) + "</svg>\n" + legend(c) + "</div></figure>\n";
}

}  // namespace gbl
