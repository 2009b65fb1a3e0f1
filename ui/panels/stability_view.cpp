// A sweep's curves: axes, lines, marks, and the bars of random configurations.
#include "ui/panels/stability_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/study/stability/stability_chart.h"

namespace gbl::ui {
namespace {

constexpr double kDust = 1e-13;  // of the largest value: float arithmetic's own, drawn as 0 is

double drawn_value(double value, const SweepAxes& axes) {
  if (!std::isfinite(value)) return axes.y.high;
  return axes.y.logarithmic && axes.y.zero_at && value < *axes.y.zero_at ? 0 : std::min(value, axes.y.high);
}

std::vector<glm::dvec2> points_of(const CurveResult& c, const SweepAxes& axes) {
  std::vector<glm::dvec2> points;
  for (const SweepRow& r : c.rows)
    if (r.value) points.push_back({r.x, drawn_value(*r.value, axes)});
  return points;
}

// Wide lines below narrow ones: curves that lie on one another are all seen.
float line_width(size_t i, size_t count) {
  return 1.5f + 4.5f * static_cast<float>(count - 1 - i) / static_cast<float>(std::max<size_t>(count, 2) - 1);
}

void draw_empty(FrameContext& f, Painter& p, const Box& frame) {
  const char* text =
      stability_input(f).running ? "Measuring: the first point is about to appear …" : "R measures this sweep.";
  const float px = p.fit(text, {frame.width() * 0.8f, frame.height()}, f.type.large, false);
  const ImVec2 size = text_size(text, px);
  p.text({frame.min.x + (frame.width() - size.x) / 2, frame.min.y + (frame.height() - size.y) / 2}, px, theme().text,
         text);
}

}  // namespace

bool curve_on(const StabilityState& s, size_t curve) { return !s.hidden.contains(curve); }
SeriesLook curve_look(size_t curve) { return series_look(curve); }

// The parameter's axis is that of the whole sweep: it stands still while points arrive.
SweepAxes sweep_axes(const FrameContext& f) {
  const Sweep& s = chosen_sweep(f);
  SweepAxes out;
  out.x = axis_for({.more_is_better = !s.log_axis}, s.values());
  std::vector<double> values;
  if (const SweepResult* result = stability_input(f).result)
    for (size_t i = 0; i < result->curves.size(); ++i)
      for (const SweepRow& r : result->curves[i].rows) {
        if (!r.value || !curve_on(f.state.of<StabilityState>(), i)) continue;
        out.not_finite |= !std::isfinite(*r.value);
        if (std::isfinite(*r.value)) values.push_back(*r.value);
      }
  double least = kNoEnd, most = 0, lowest = 0;
  for (const double v : values) {
    most = std::max(most, v), lowest = std::min(lowest, v);
    if (v > 0) least = std::min(least, v);
  }
  for (double& v : values)
    if (std::abs(v) < kDust * most) v = 0;
  const bool zeros = std::find(values.begin(), values.end(), 0) != values.end();
  const bool shares = zeros && most <= 1 && least > 1e-3;  // a logarithm would make little of it
  out.y = axis_for({.more_is_better = !(f.state.of<StabilityState>().log_y.value_or(!shares) && lowest >= 0)}, values);
  if (out.not_finite) out.y.high = out.y.logarithmic ? 10 * out.y.high : 1.15 * out.y.high;
  return out;
}

void draw_sweep_curves(FrameContext& f, Painter& p, Plot& plot) {
  const StabilityState& s = f.state.of<StabilityState>();
  const SweepResult* result = stability_input(f).result;
  const SweepAxes axes = sweep_axes(f);
  plot.draw_axes();
  if (!result || stability_input(f).done == 0) return draw_empty(f, p, plot.frame());
  const float radius = std::round(f.type.small * 0.36f);
  const size_t n = result->curves.size();
  const auto draw = [&](size_t i, float width, float mark) {
    const std::vector<glm::dvec2> points = points_of(result->curves[i], axes);
    plot.draw_line(points, curve_look(i).colour, width);
    plot.draw_marks(points, curve_look(i), mark);
  };
  for (size_t i = 0; i < n; ++i)
    if (i != s.curve && curve_on(s, i)) draw(i, line_width(i, n), radius);
  if (s.curve >= n || !curve_on(s, s.curve)) return;
  plot.draw_line(points_of(result->curves[s.curve], axes), theme().background, 11);  // a dark edge: it stands out
  draw(s.curve, 7, radius * 1.5f);
  if (!axes.not_finite) return;
  const char* text = "at the upper edge: not finite";
  p.text({plot.frame().max.x - text_size(text, f.type.small).x - 4, plot.frame().min.y + 2}, f.type.small, theme().text,
         text);
}

// A line per variant: of each family how many configurations had a wrong pixel, and how much light was lost.
void draw_sweep_families(FrameContext& f, Painter& p, const Box& box) {
  const SweepResult* result = stability_input(f).result;
  if (!result || stability_input(f).done == 0) return draw_empty(f, p, box);
  const size_t lines = result->curves.size() + 1;
  const float line = box.height() / static_cast<float>(lines);
  const float px = std::max(kSmallestPx, std::floor(std::min(f.type.body, line * 0.62f)));
  float names = 0;
  for (const CurveResult& c : result->curves) names = std::max(names, text_size(c.curve, px).x + px);
  names = std::min(names, box.width() * 0.4f);
  const float column = (box.width() - names) / kFamilies;
  const auto cell = [&](size_t row, int family) {
    const float x = box.min.x + names + column * static_cast<float>(family);
    const float y = box.min.y + line * static_cast<float>(row);
    return Box{{std::round(x), std::round(y)}, {std::round(x + column - px * 0.6f), std::round(y + line - 3)}};
  };
  const auto middle = [&](const Box& b) { return b.min.y + (b.height() - px * 1.17f) / 2; };
  const auto words_in = [&](const Box& b, ImU32 colour, const std::string& text) {
    p.text_in({{b.min.x + px * 0.3f, middle(b)}, {b.max.x, b.max.y + px}}, px, colour, text);
  };
  for (int family = 0; family < kFamilies; ++family) {
    size_t most = 0;  // the variants of a configuration come one after the other
    for (const CurveResult& c : result->curves) most = std::max(most, family_shares(c, family).configurations);
    words_in(cell(0, family), theme().dim, fmt::format("family {}: of {}", "ABC"[family], most));
  }
  for (size_t i = 0; i < result->curves.size(); ++i) {
    const CurveResult& c = result->curves[i];
    const Box first = cell(i + 1, 0);
    const bool chosen = i == f.state.of<StabilityState>().curve;
    p.text_in({{box.min.x, middle(first)}, {first.min.x - 4, first.max.y + px}}, px,
              chosen ? theme().accent : theme().text, c.curve);
    if (!c.not_drawn.empty()) {
      words_in({first.min, cell(i + 1, kFamilies - 1).max}, theme().dim, "not drawn here");
      continue;
    }
    for (int family = 0; family < kFamilies; ++family) {
      const Box b = cell(i + 1, family);
      const FamilyShares s = family_shares(c, family);
      p.fill(b, theme().surface, 2);
      if (s.configurations == 0) continue;
      const auto share = static_cast<float>(s.wrong);
      if (share > 0) p.fill({b.min, {b.min.x + share * b.width(), b.max.y}}, theme().wrong, 2);
      words_in(b, theme().text, fmt::format("{:.0f} % wrong, {:.1f} % lost", 100 * s.wrong, 100 * s.lost));
    }
  }
}

std::vector<StatedLine> stated_lines(const FrameContext& f) {
  const StabilityInput& in = stability_input(f);
  std::vector<StatedLine> lines;
  if (!in.result) return lines;
  using Kind = StatedLine::Mark;
  for (size_t i = 0; i < in.result->curves.size(); ++i) {
    const CurveResult& c = in.result->curves[i];
    if (!c.not_drawn.empty()) {
      lines.push_back({i, "not drawn on this device: " + c.not_drawn, Kind::not_drawn});
      continue;
    }
    for (const Judged& j : c.judged)
      lines.push_back({i, j.statement + (j.verdict.holds ? "" : fmt::format(". DOES NOT HOLD: {}", j.verdict.where)),
                       j.verdict.holds ? Kind::holds : Kind::fails});
    if (c.judged.empty() && i < in.stated.size())
      for (const std::string& text : in.stated[i]) lines.push_back({i, text, Kind::open});
  }
  const auto rank = [&](const StatedLine& l) {
    return l.curve == f.state.of<StabilityState>().curve ? 0 : l.mark == Kind::fails ? 1 : 2;
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const StatedLine& a, const StatedLine& b) { return rank(a) < rank(b); });
  return lines;
}

}  // namespace gbl::ui
