// chart_script(): the points of a chart as a text for gnuplot.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/glm.hpp>

#include "renderer/study/charts/gnuplot.h"
#include "renderer/study/charts/label_places.h"

namespace gbl {
namespace {

// Pixels of the picture; the frame's place in it is fixed, so that names can be kept apart from marks.
constexpr glm::dvec2 kPicture{1280, 800};
constexpr glm::dvec2 kFrameFrom{0.085, 0.1}, kFrameTo{0.755, 0.91};  // shares of the picture
constexpr glm::dvec2 kFrame = kPicture * (kFrameTo - kFrameFrom);
constexpr glm::dvec2 kLetter{9.2, 18};   // of a name, on the average
constexpr double kMark = 7, kRing = 12;  // radii

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

// gnuplot takes a tick's label for a format of its number.
std::string tick_text(const std::string& label) {
  const bool percent = label.ends_with('%');
  return "'" + label + (percent ? "%'" : "'");
}

std::string axis_lines(const char* name, const StudyColumn& column, const ChartAxis& axis) {
  std::string text = fmt::format("set {0}label {1}\nset {0}range [{2}:{3}]\n", name, gnuplot_text(axis_title(column)),
                                 axis.low, axis.high);
  if (axis.logarithmic) text += fmt::format("set logscale {}\n", name);
  std::string ticks;
  for (const ChartTick& t : ticks_of(axis))
    ticks += fmt::format("{}{} {}", ticks.empty() ? "" : ", ", tick_text(t.label), t.at);
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

glm::dvec2 place_in_frame(const Places& places, const ChartPoint& p) {
  return kFrame * glm::dvec2(places.x.along(p.cost), places.y.along(p.error));
}

std::string graph(glm::dvec2 pixels) {
  return fmt::format("graph {:.5f},{:.5f}", pixels.x / kFrame.x, pixels.y / kFrame.y);
}

std::string label_line(const ChartPoint& p, const PlacedLabel& label, glm::dvec2 mark) {
  std::string text =
      fmt::format("set label {} at {} center front\n", gnuplot_text(field(p.label)), graph(label.box.middle()));
  if (label.line_to)
    text += fmt::format("set arrow from {} to {} nohead lc rgb '#666666' lw 0.7 back\n", graph(mark),
                        graph(*label.line_to));
  return text;
}

// Presets by name, each where it lies on no mark and no other name.
std::string label_lines(const Chart& chart, const Places& places) {
  std::vector<ChartMark> marks;
  std::vector<LabelWish> wishes;
  std::vector<const ChartPoint*> named;
  for (const ChartPoint& p : chart.points) {
    marks.push_back({place_in_frame(places, p), p.preset ? kRing : kMark});
    if (!p.preset) continue;
    wishes.push_back({marks.back().at, kRing, kLetter * glm::dvec2(static_cast<double>(p.label.size()), 1)});
    named.push_back(&p);
  }
  const std::vector<std::optional<PlacedLabel>> found = place_labels(kFrame, marks, wishes);
  std::string text;
  for (size_t i = 0; i < found.size(); ++i)
    if (found[i]) text += label_line(*named[i], *found[i], wishes[i].at);
  return text;
}

// Zero has a row of its own on a logarithmic axis, which knows none.
std::string zero_rows(const Places& places) {
  constexpr double kHalf = 14;  // pixels
  std::string text;
  const auto band = [&](glm::dvec2 from, glm::dvec2 to) {
    text += fmt::format("set object rectangle from {} to {} fc rgb '#f0ece0' fs solid noborder behind\n", graph(from),
                        graph(to));
  };
  if (places.y.zero_at) {
    const double at = kFrame.y * places.y.along(0);
    band({0, at - kHalf}, {kFrame.x, at + kHalf});
  }
  if (places.x.zero_at) {
    const double at = kFrame.x * places.x.along(0);
    band({at - kHalf, 0}, {at + kHalf, kFrame.y});
  }
  return text;
}

// Crosses over points whose times spread too far.
std::string noisy_block(const Chart& chart, const Places& places) {
  std::string text = "$NOISY << EOD\n";
  for (const ChartPoint& p : chart.points)
    if (p.noisy) text += places.of(p) + "\n";
  return text + "EOD\n";
}

// The sound points of a family, or the others; "" = none.
std::string family_block(const Chart& chart, const Places& places, size_t family, bool sound) {
  std::string text;
  for (const ChartPoint& p : chart.points)
    if (p.family == chart.families[family] && p.sound == sound) text += places.of(p) + "\n";
  return text.empty() ? "" : fmt::format("${}{} << EOD\n{}EOD\n", sound ? "S" : "U", family, text);
}

std::string family_plot(const Chart& chart, size_t family, bool sound) {
  return fmt::format(", \\\n  ${}{} using 1:2 with points pt {} ps 1.2 lc rgb '{}' title {}", sound ? "S" : "U", family,
                     series_shape(family, sound), series_colour(family),
                     gnuplot_text(chart.families[family].empty() ? "other" : chart.families[family]));
}

// The families of the sound points under one heading, those of the others under the next.
struct FamilyPlots {
  std::string blocks, plots;
};
FamilyPlots family_plots(const Chart& chart, const Places& places) {
  FamilyPlots out;
  for (const bool sound : {true, false}) {
    std::string plots;
    for (size_t i = 0; i < chart.families.size(); ++i) {
      const std::string block = family_block(chart, places, i, sound);
      out.blocks += block;
      if (!block.empty()) plots += family_plot(chart, i, sound);
    }
    if (!plots.empty()) out.plots += ", \\\n  " + legend_heading(sound ? "sound (filled):" : "unsound (open):") + plots;
  }
  return out;
}

std::string plot_line(const Chart& chart, const FamilyPlots& families) {
  std::string text = "plot $FRONT using 1:2 with steps lw 2 lc rgb '#888888' title 'Pareto front'" + families.plots;
  if (std::any_of(chart.points.begin(), chart.points.end(), [](const ChartPoint& p) { return p.preset; }))
    text += ", \\\n  $PRESETS using 1:2 with points pt 6 ps 2.4 lw 1.5 lc rgb '#000000' title 'preset'";
  if (std::any_of(chart.points.begin(), chart.points.end(), [](const ChartPoint& p) { return p.noisy; }))
    text += ", \\\n  $NOISY using 1:2 with points pt 2 ps 1.8 lw 1.5 lc rgb '#b00020' title 'noisy time'";
  return text + "\n";
}

}  // namespace

std::string chart_script(const Chart& chart, const ChartTexts& texts, ChartFile file) {
  const Places places = places_of(chart);
  std::string text = fmt::format("set terminal {} size {},{} font 'DejaVu Sans,12' noenhanced background '#ffffff'\n",
                                 file == ChartFile::svg ? "svg" : "pngcairo", kPicture.x, kPicture.y);
  text += "set encoding utf8\nset datafile separator \"\\t\"\nset grid xtics ytics lt 1 lc rgb '#dddddd'\n";
  text += "set key at graph 1.02,1 left top Left reverse samplen 1.5\n";
  text += fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n",
      kFrameFrom.x, kFrameTo.x, kFrameFrom.y, kFrameTo.y);
  text += fmt::format("set title {}.\"\\n\".{}\n", gnuplot_text(texts.title), gnuplot_text(texts.subtitle));
  text += axis_lines("x", chart.x, places.x) + axis_lines("y", chart.y, places.y) + zero_rows(places);
  const FamilyPlots families = family_plots(chart, places);
  text += front_block(chart, places) + preset_block(chart, places) + noisy_block(chart, places) + families.blocks;
  return text + label_lines(chart, places) + plot_line(chart, families);
}

}  // namespace gbl
