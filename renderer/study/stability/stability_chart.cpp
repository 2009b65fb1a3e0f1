#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/study/stability/stability_chart_parts.h"

namespace gbl {

using namespace stability;

namespace {

constexpr double kDecades = 1e-13;        // more are not drawn: float arithmetic's own dust
constexpr double kLogarithmicFrom = 100;  // largest over smallest value above 0

// ---- the error's axis -----------------------------------------------------------------------------------------------

struct ValueAxis {
  bool logarithmic = false, zeros = false, folded = false, not_finite = false;
  double low = 0, high = 1;  // of the axis
  double least = 0;          // smaller values are drawn as 0 is
  double zero_at = 0, top = 1;
  bool percent = false;

  std::string shown(double v) const { return fmt::format("{}", percent ? 100 * v : v); }
  double place(double value) const {
    if (!std::isfinite(value)) return top;
    return logarithmic && value < least ? zero_at : value;
  }
};

ValueAxis axis_of(const SweepResult& result) {
  ValueAxis a{.percent = is_share(sweep_metric(result.sweep->metric))};
  double least = kNoEnd, most = 0, lowest = 0;
  for (const CurveResult& c : result.curves)
    for (const SweepRow& r : c.rows) {
      if (!r.value) continue;
      if (std::isfinite(*r.value)) lowest = std::min(lowest, *r.value);
      a.not_finite |= !std::isfinite(*r.value), a.zeros |= *r.value == 0;
      if (!std::isfinite(*r.value) || !(*r.value > 0)) continue;
      least = std::min(least, *r.value), most = std::max(most, *r.value);
    }
  if (lowest < 0) {  // a difference with its sign
    a.top = 1.1 * std::max(most, 0.0), a.low = 1.15 * lowest, a.high = 1.15 * std::max(most, -0.1 * lowest);
    return a;
  }
  if (!(most > 0)) return a;
  const bool counts_shares = a.zeros && most <= 1 && least > 1e-3;
  a.logarithmic = most > kLogarithmicFrom * least && !counts_shares;
  if (a.logarithmic) {
    a.folded = least < kDecades * most, a.zeros |= a.folded;
    least = a.least = std::max(least, kDecades * most);
    a.zero_at = std::pow(10, std::floor(std::log10(least)) - 1), a.top = 10 * most;
    a.low = a.zeros ? a.zero_at / 2 : least / 2, a.high = (a.not_finite ? 20 : 2) * most;
  } else {
    a.top = 1.1 * most, a.low = -0.03 * most, a.high = 1.15 * most;
  }
  return a;
}

// Zero has a row of its own on a logarithmic axis, which knows none.
std::string zero_row(const ValueAxis& a) {
  constexpr double kHalf = 1.3;
  return fmt::format(
      "set object rectangle from graph 0, first {} to graph 1, first {} fc rgb '#f0ece0' fs solid noborder behind\n",
      a.shown(a.zero_at / kHalf), a.shown(a.zero_at * kHalf));
}

std::string axis_lines(const ValueAxis& a) {
  std::string text =
      fmt::format("set yrange [{}:{}]\nset format y '%g{}'\n", a.shown(a.low), a.shown(a.high), a.percent ? " %%" : "");
  if (a.logarithmic) text += "set logscale y\n";
  if (a.logarithmic && a.zeros) {
    const std::string least = fmt::format("< {:.0g}{}", a.percent ? 100 * a.least : a.least, a.percent ? " %%" : "");
    text += zero_row(a) + fmt::format("set ytics add ('{}' {})\n", a.folded ? least : "0", a.shown(a.zero_at));
  }
  if (a.not_finite) text += fmt::format("set ytics add ('not finite' {})\n", a.shown(a.top));
  return text;
}

// ---- curves ---------------------------------------------------------------------------------------------------------

std::string block(const CurveResult& c, size_t number, const ValueAxis& axis) {
  std::string text = fmt::format("$C{} << EOD\n", number);
  for (const SweepRow& r : c.rows)
    text += r.value ? fmt::format("{}\t{}\n", r.x, axis.shown(axis.place(*r.value))) : "\n";
  return text + "EOD\n";
}

// Wide lines below narrow ones: curves that lie on one another are all seen.
double line_width(size_t i, size_t count) {
  return 1.5 + 5.0 * double(count - 1 - i) / double(std::max<size_t>(count, 2) - 1);
}

// gnuplot's own would end at whole decades; where there are few of them 2 and 5 are named, too.
std::string range_of(const SweepResult& result) {
  double least = kNoEnd, most = 0;
  for (const CurveResult& c : result.curves)
    for (const SweepRow& r : c.rows) least = std::min(least, r.x), most = std::max(most, r.x);
  if (!(most > 0)) return "";
  std::string text = fmt::format("set xrange [{}:{}]\n", least / 1.3, most * 1.3);
  if (most > 1000 * least) return text;
  for (int power = static_cast<int>(std::floor(std::log10(least))); std::pow(10, power) < most; ++power)
    text += fmt::format("set xtics add ('{0:g}' {0}, '{1:g}' {1})\n", 2 * std::pow(10, power), 5 * std::pow(10, power));
  return text;
}

// A negative interval of points clears the line below each: open marks stay open.
std::string curve_plot(const CurveResult& c, size_t i, size_t count) {
  return fmt::format("$C{} using 1:2 with linespoints pi -1 pt {} ps 1.1 lw {:.2f} lc rgb '{}' title {}", i,
                     series_shape(i, sound(c.settings)), line_width(i, count), series_colour(i),
                     gnuplot_text(key_of(c)));
}

std::string curves_text(const SweepResult& result) {
  const Sweep& s = *result.sweep;
  const ValueAxis axis = axis_of(result);
  std::string text = axis_lines(axis) + fmt::format("set xlabel {}\n", gnuplot_text(titled(s.parameter, s.unit)));
  if (s.log_axis) text += "set logscale x\nset format x '%g'\n" + range_of(result);
  std::string plots;
  for (const bool sound : {true, false}) {
    std::string group;
    for (size_t i = 0; i < result.curves.size(); ++i) {
      const CurveResult& c = result.curves[i];
      if (c.rows.empty() || gbl::sound(c.settings) != sound) continue;
      text += block(c, i, axis);
      group += ", \\\n  " + curve_plot(c, i, result.curves.size());
    }
    const char* heading = sound ? "sound (filled):" : "unsound (open):";
    if (!group.empty()) plots += (plots.empty() ? "" : ", \\\n  ") + legend_heading(heading) + group;
  }
  return text + "plot " + plots + "\n";
}

}  // namespace

std::string stability_script(const SweepResult& result, const std::string& device, StabilityFile file) {
  const Sweep& s = *result.sweep;
  const SweepMetric& metric = sweep_metric(s.metric);
  std::string text =
      fmt::format("set terminal {} size 1280,800 font 'DejaVu Sans,12' noenhanced background '#ffffff'\n",
                  file == StabilityFile::svg ? "svg" : "pngcairo");
  text +=
      "set encoding utf8\nset datafile separator \"\\t\"\nset grid lc rgb '#dddddd'\nset key outside right top Left "
      "reverse\n";
  text += fmt::format("set title {}\n", quoted_lines(fmt::format("{}\n{}\n{}", s.label, wrapped(s.help, 90), device)));
  if (has_families(s))
    return text + "set ylabel 'configurations with any pixel over 1/255 (%)'\n" + families_text(result);
  if (all_or_nothing(result))
    return text + fmt::format("set ylabel {}\n", quoted_lines("0 to 1: " + wrapped(metric.help, 70))) +
           lanes_text(result);
  return text +
         fmt::format("set ylabel {}\n",
                     quoted_lines(titled(metric.id, metric.unit) + "\n" + wrapped(metric.help, 70))) +
         curves_text(result);
}

}  // namespace gbl
