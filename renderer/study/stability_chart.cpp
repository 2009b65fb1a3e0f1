#include "renderer/study/stability_chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gbl {
namespace {

// Okabe and Ito 2008, "Color Universal Design", without their yellow: too pale on white.
constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
// gnuplot's numbers: disc, square, triangles, diamond, pentagon; the same open; plus, cross, star. 13 shapes and 7
// colours have no common factor: 91 curves differ.
constexpr int kShapes[] = {7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14, 1};
constexpr double kDecades = 1e-10;        // more are not drawn: float arithmetic's own dust
constexpr double kLogarithmicFrom = 100;  // largest over smallest value above 0

// In single quotes nothing is special but the quote itself.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

std::string titled(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : fmt::format("{} ({})", label, unit);
}

std::string wrapped(const std::string& text, size_t width) {
  std::string out;
  size_t column = 0;
  for (const char c : text) {
    const bool turn = c == ' ' && column > width;
    out += turn ? '\n' : c;
    column = turn ? 0 : column + 1;
  }
  return out;
}

// Lines of a text, each quoted, joined by gnuplot.
std::string quoted_lines(const std::string& text) {
  std::string out, line;
  for (const char c : text + "\n") {
    if (c != '\n') {
      line += c;
      continue;
    }
    out += (out.empty() ? "" : ".\"\\n\".") + quoted(line);
    line.clear();
  }
  return out;
}

// ---- the error's axis -----------------------------------------------------------------------------------------------

struct ValueAxis {
  bool logarithmic = false, zeros = false, not_finite = false;
  double low = 0, high = 1;  // of the axis
  double least = 0;          // smaller values are drawn as 0 is
  double zero_at = 0, top = 1;

  double place(double value) const {
    if (!std::isfinite(value)) return top;
    return logarithmic && value < least ? zero_at : value;
  }
};

ValueAxis axis_of(const SweepResult& result) {
  ValueAxis a;
  double least = kNoEnd, most = 0;
  for (const CurveResult& c : result.curves)
    for (const SweepRow& r : c.rows) {
      if (!r.value) continue;
      a.not_finite |= !std::isfinite(*r.value), a.zeros |= *r.value == 0;
      if (!std::isfinite(*r.value) || !(*r.value > 0)) continue;
      least = std::min(least, *r.value), most = std::max(most, *r.value);
    }
  if (!(most > 0)) return a;
  const bool counts_shares = a.zeros && most <= 1 && least > 1e-3;
  a.logarithmic = most > kLogarithmicFrom * least && !counts_shares;
  if (a.logarithmic) {
    a.zeros |= least < kDecades * most;
    least = a.least = std::max(least, kDecades * most);
    a.zero_at = std::pow(10, std::floor(std::log10(least)) - 1), a.top = 10 * most;
    a.low = a.zeros ? a.zero_at / 2 : least / 2, a.high = (a.not_finite ? 20 : 2) * most;
  } else {
    a.top = 1.1 * most, a.low = -0.03 * most, a.high = 1.15 * most;
  }
  return a;
}

std::string axis_lines(const ValueAxis& a) {
  std::string text = fmt::format("set yrange [{}:{}]\n", a.low, a.high);
  if (a.logarithmic) text += "set logscale y\nset format y '%g'\n";
  if (a.logarithmic && a.zeros) text += fmt::format("set ytics add ('0…' {})\n", a.zero_at);
  if (a.not_finite) text += fmt::format("set ytics add ('not finite' {})\n", a.top);
  return text;
}

// ---- curves ---------------------------------------------------------------------------------------------------------

bool holds(const CurveResult& c) {
  return std::all_of(c.judged.begin(), c.judged.end(), [](const Judged& j) { return j.verdict.holds; });
}

std::string key_of(const CurveResult& c) { return holds(c) ? c.curve : c.curve + " (not as stated)"; }

std::string block(const CurveResult& c, size_t number, const ValueAxis& axis) {
  std::string text = fmt::format("$C{} << EOD\n", number);
  for (const SweepRow& r : c.rows) text += r.value ? fmt::format("{}\t{}\n", r.x, axis.place(*r.value)) : "\n";
  return text + "EOD\n";
}

// Wide lines below narrow ones: curves that lie on one another are all seen.
double line_width(size_t i, size_t count) {
  return 1.5 + 5.0 * double(count - 1 - i) / double(std::max<size_t>(count, 2) - 1);
}

// gnuplot's own would end at whole decades.
std::string range_of(const SweepResult& result) {
  double least = kNoEnd, most = 0;
  for (const CurveResult& c : result.curves)
    for (const SweepRow& r : c.rows) least = std::min(least, r.x), most = std::max(most, r.x);
  return most > 0 ? fmt::format("set xrange [{}:{}]\n", least / 1.3, most * 1.3) : "";
}

std::string curves_text(const SweepResult& result) {
  const Sweep& s = *result.sweep;
  const ValueAxis axis = axis_of(result);
  std::string text = axis_lines(axis) + fmt::format("set xlabel {}\n", quoted(titled(s.parameter, s.unit)));
  if (s.log_axis) text += "set logscale x\nset format x '%g'\n" + range_of(result);
  std::string plot;
  size_t drawn = 0;
  for (const CurveResult& c : result.curves) {
    if (c.rows.empty()) continue;
    text += block(c, drawn, axis);
    plot +=
        fmt::format("{}$C{} using 1:2 with linespoints pt {} ps 0.9 lw {:.2f} lc rgb '{}' title {}",
                    plot.empty() ? "plot " : ", \\\n  ", drawn, kShapes[drawn % std::size(kShapes)],
                    line_width(drawn, result.curves.size()), kColours[drawn % std::size(kColours)], quoted(key_of(c)));
    ++drawn;
  }
  return text + plot + "\n";
}

// ---- families -------------------------------------------------------------------------------------------------------

std::string families_text(const SweepResult& result) {
  std::string text =
      "set style data histograms\nset style histogram clustered gap 1\nset style fill solid\nset boxwidth 0.9\n"
      "set xtics rotate by -35\nset yrange [0:105]\n$D << EOD\n";
  for (const CurveResult& c : result.curves) {
    if (c.rows.empty()) continue;
    text += key_of(c);
    for (int family = 0; family < 3; ++family) text += fmt::format("\t{}", 100 * family_shares(c, family).wrong);
    text += "\n";
  }
  text += "EOD\nplot ";
  for (int family = 0; family < 3; ++family)
    text += fmt::format("{}$D using {}:xtic(1) lc rgb '{}' title 'family {}'", family == 0 ? "" : ", ", family + 2,
                        kColours[family], "ABC"[family]);
  return text + "\n";
}

}  // namespace

FamilyShares family_shares(const CurveResult& c, int family) {
  FamilyShares out;
  double wrong = 0, lost = 0, lit = 0;
  for (const SweepRow& r : c.rows) {
    if (static_cast<int>(r.x) / kFamilySpan != family) continue;
    ++out.configurations;
    wrong += !(r.value && *r.value <= 0);
    lost += r.errors.lost_pixels.value_or(0), lit += r.lit_pixels;
    out.worst_linear = std::max(out.worst_linear, r.errors.max_linear.value_or(0));
  }
  if (out.configurations > 0) out.wrong = wrong / static_cast<double>(out.configurations);
  if (lit > 0) out.lost = lost / lit;
  return out;
}

std::string stability_script(const SweepResult& result, const std::string& device, StabilityFile file) {
  const Sweep& s = *result.sweep;
  const SweepMetric& metric = sweep_metric(s.metric);
  std::string text =
      fmt::format("set terminal {} size 1280,800 font 'DejaVu Sans,12' noenhanced background '#ffffff'\n",
                  file == StabilityFile::svg ? "svg" : "pngcairo");
  text += "set encoding utf8\nset datafile separator \"\\t\"\nset grid lc rgb '#dddddd'\nset key outside right top\n";
  text += fmt::format("set title {}\n", quoted_lines(fmt::format("{}\n{}\n{}", s.label, wrapped(s.help, 80), device)));
  if (has_families(s))
    return text + "set ylabel 'configurations with any pixel over 1/255 (%)'\n" + families_text(result);
  return text +
         fmt::format("set ylabel {}\n",
                     quoted_lines(titled(metric.id, metric.unit) + "\n" + wrapped(metric.help, 70))) +
         curves_text(result);
}

}  // namespace gbl
