// chart_script(): the points of a chart as a text for gnuplot.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/glm.hpp>

#include "renderer/study/charts/gnuplot.h"

namespace gbl {
namespace {

// Okabe and Ito 2008, "Color Universal Design", without their yellow: too pale on white.
constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
// gnuplot's numbers: disc, square, triangles, diamond, pentagon; the same open; plus, cross, star. 13 shapes and 7
// colours have no common factor: 91 families differ, neighbours in both.
constexpr int kShapes[] = {7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14, 1};

// A text as a field of a data block.
std::string field(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '"') c = ' ';
  return text;
}

struct Places {
  ChartAxis x, y;
  std::string of(const ChartPoint& p) const { return fmt::format("{}\t{}", x.place(p.cost), y.place(p.error)); }
};

Places places_of(const Chart& chart) {
  std::vector<double> costs, errors;
  for (const ChartPoint& p : chart.points) costs.push_back(p.cost), errors.push_back(p.error);
  return {axis_for(chart.x, costs), axis_for(chart.y, errors)};
}

std::string axis_lines(const char* name, const StudyColumn& column, const ChartAxis& axis) {
  std::string text = fmt::format("set {0}label {1}\nset {0}range [{2}:{3}]\n", name, gnuplot_text(axis_title(column)),
                                 axis.low, axis.high);
  if (axis.logarithmic) text += fmt::format("set logscale {}\n", name);
  std::string ticks;
  for (const ChartTick& t : ticks_of(axis)) ticks += fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", t.label, t.at);
  return text + fmt::format("set {}tics ({})\n", name, ticks);
}

// The front as a staircase: what a budget buys, up to the right edge.
std::string front_block(const Chart& chart, const Places& places) {
  std::vector<const ChartPoint*> front;
  for (const ChartPoint& p : chart.points)
    if (p.on_front) front.push_back(&p);
  std::sort(front.begin(), front.end(), [](auto* a, auto* b) { return a->cost < b->cost; });
  std::string text = "$FRONT << EOD\n";
  for (const ChartPoint* p : front) text += places.of(*p) + "\n";
  if (!front.empty()) text += fmt::format("{}\t{}\n", places.x.high, places.y.place(front.back()->error));
  return text + "EOD\n";
}

// The rings round presets.
std::string preset_block(const Chart& chart, const Places& places) {
  std::string text = "$PRESETS << EOD\n";
  for (const ChartPoint& p : chart.points)
    if (p.preset) text += places.of(p) + "\n";
  return text + "EOD\n";
}

// A label's place about its point, in characters of the chart's font.
struct LabelPlace {
  double x, y;
  const char* align;
};
constexpr LabelPlace kLabelPlaces[] = {{0, 1, "center"},   {1.4, 0, "left"},    {-1.4, 0, "right"}, {0, -1, "center"},
                                       {1.4, 1, "left"},   {-1.4, 1, "right"},  {1.4, -1, "left"},  {-1.4, -1, "right"},
                                       {0, 2, "center"},   {0, -2, "center"},   {1.4, 2, "left"},   {1.4, -2, "left"},
                                       {-1.4, 2, "right"}, {-1.4, -2, "right"}, {0, 3, "center"},   {0, -3, "center"}};

struct LabelBox {
  double left, right, low, high;  // in characters, from the chart's corner
  bool meets(const LabelBox& b) const { return left < b.right && b.left < right && low < b.high && b.low < high; }
};

// About as many characters as the frame is wide and high at this size: enough to keep labels apart.
constexpr double kCharactersWide = 100, kCharactersHigh = 34;

double share_along(const ChartAxis& axis, double value) {
  if (!axis.logarithmic) return (value - axis.low) / (axis.high - axis.low);
  return std::log(axis.place(value) / axis.low) / std::log(axis.high / axis.low);
}

LabelBox box_of(glm::dvec2 at, const LabelPlace& place, size_t letters) {
  const double width = static_cast<double>(letters);
  const double align = place.align[0] == 'l' ? 0 : place.align[0] == 'r' ? 1 : 0.5;
  const double left = at.x + place.x - align * width, middle = at.y + place.y;
  return {left, left + width, middle - 0.45, middle + 0.45};
}

// Presets by name, each where it meets no other name and no preset's ring, if there is such a place.
std::string label_lines(const Chart& chart, const Places& places) {
  const auto characters = [&](const ChartPoint& p) {
    return glm::dvec2(share_along(places.x, p.cost) * kCharactersWide,
                      share_along(places.y, p.error) * kCharactersHigh);
  };
  std::string text;
  std::vector<LabelBox> taken;
  for (const ChartPoint& p : chart.points)
    if (const glm::dvec2 at = characters(p); p.preset) taken.push_back({at.x - 1, at.x + 1, at.y - 0.5, at.y + 0.5});
  for (const ChartPoint& p : chart.points) {
    if (!p.preset) continue;
    const auto is_free = [&](const LabelPlace& place) {
      const LabelBox box = box_of(characters(p), place, p.label.size());
      const bool inside = box.left > 0 && box.right < kCharactersWide && box.low > 0 && box.high < kCharactersHigh;
      return inside && std::none_of(taken.begin(), taken.end(), [&](const LabelBox& t) { return t.meets(box); });
    };
    const auto found = std::find_if(std::begin(kLabelPlaces), std::end(kLabelPlaces), is_free);
    const LabelPlace& place = found == std::end(kLabelPlaces) ? kLabelPlaces[0] : *found;
    taken.push_back(box_of(characters(p), place, p.label.size()));
    text += fmt::format("set label {} at {},{} {} offset character {},{} front\n", gnuplot_text(field(p.label)),
                        places.x.place(p.cost), places.y.place(p.error), place.align, place.x, place.y);
  }
  return text;
}

std::string family_block(const Chart& chart, const Places& places, size_t family) {
  std::string text = fmt::format("$F{} << EOD\n", family);
  for (const ChartPoint& p : chart.points)
    if (p.family == chart.families[family]) text += places.of(p) + "\n";
  return text + "EOD\n";
}

std::string plot_line(const Chart& chart) {
  std::string text = "plot $FRONT using 1:2 with steps lw 2 lc rgb '#888888' title 'Pareto front'";
  for (size_t i = 0; i < chart.families.size(); ++i)
    text += fmt::format(", \\\n  $F{} using 1:2 with points pt {} ps 1.1 lc rgb '{}' title {}", i,
                        kShapes[i % std::size(kShapes)], kColours[i % std::size(kColours)],
                        gnuplot_text(chart.families[i].empty() ? "other" : chart.families[i]));
  if (std::any_of(chart.points.begin(), chart.points.end(), [](const ChartPoint& p) { return p.preset; }))
    text += ", \\\n  $PRESETS using 1:2 with points pt 6 ps 2.2 lw 1.5 lc rgb '#000000' title 'preset'";
  return text + "\n";
}

}  // namespace

std::string chart_script(const Chart& chart, const ChartTexts& texts, ChartFile file) {
  const Places places = places_of(chart);
  std::string text =
      fmt::format("set terminal {} size 1280,800 font 'DejaVu Sans,12' noenhanced background '#ffffff'\n",
                  file == ChartFile::svg ? "svg" : "pngcairo");
  text +=
      "set encoding utf8\nset datafile separator \"\\t\"\nset grid xtics ytics lt 1 lc rgb '#dddddd'\nset key outside "
      "right top\n";
  text += fmt::format("set title {}.\"\\n\".{}\n", gnuplot_text(texts.title), gnuplot_text(texts.subtitle));
  text += axis_lines("x", chart.x, places.x) + axis_lines("y", chart.y, places.y);
  text += front_block(chart, places) + preset_block(chart, places);
  for (size_t i = 0; i < chart.families.size(); ++i) text += family_block(chart, places, i);
  text += label_lines(chart, places);
  return text + plot_line(chart);
}

}  // namespace gbl
