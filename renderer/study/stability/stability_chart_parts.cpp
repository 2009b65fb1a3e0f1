#include "renderer/study/stability/stability_chart_parts.h"

#include <algorithm>
#include <fmt/format.h>

namespace gbl::stability {

std::string titled(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : fmt::format("{} ({})", label, unit);
}

std::string wrapped(const std::string& text, size_t width) {
  const size_t lines = text.size() / width + 1;
  std::string out;
  size_t column = 0;
  for (const char c : text) {
    const bool turn = c == ' ' && column * lines >= text.size();
    out += turn ? '\n' : c;
    column = turn ? 0 : column + 1;
  }
  return out;
}

std::string quoted_lines(const std::string& text) {
  std::string out, line;
  for (const char c : text + "\n") {
    if (c != '\n') {
      line += c;
      continue;
    }
    out += (out.empty() ? "" : ".\"\\n\".") + gnuplot_text(line);
    line.clear();
  }
  return out;
}

std::string key_of(const CurveResult& c) {
  const bool holds = std::all_of(c.judged.begin(), c.judged.end(), [](const Judged& j) { return j.verdict.holds; });
  return holds ? c.curve : c.curve + " (not as stated)";
}

bool is_share(const SweepMetric& m) { return std::string_view(m.id).ends_with("_share"); }

bool all_or_nothing(const SweepResult& result) {
  double most = 0;
  for (const CurveResult& c : result.curves)
    for (const SweepRow& r : c.rows) most = std::max(most, r.value.value_or(0));
  return is_share(sweep_metric(result.sweep->metric)) && most > 0.99;
}

static constexpr double kLaneFilled = 0.75;  // of a lane's height, by a share of 1

std::string lanes_text(const SweepResult& result) {
  const Sweep& s = *result.sweep;
  std::string text =
      fmt::format("set xlabel {}\nunset key\nset style fill solid 0.6\n", gnuplot_text(titled(s.parameter, s.unit)));
  std::string plot, names;
  int lane = 0;
  for (const CurveResult& c : result.curves) {
    if (c.rows.empty()) continue;
    text += fmt::format("$C{} << EOD\n", lane);
    for (const SweepRow& r : c.rows)
      text += r.value ? fmt::format("{}\t{}\n", r.x, -lane + kLaneFilled * std::min(*r.value, 1.0)) : "\n";
    text += "EOD\n";
    plot += fmt::format(
        "{0}$C{1} using 1:2 with filledcurves y1={2} lc rgb '{3}', \\\n  $C{1} using 1:2 with linespoints "
        "pt 7 ps 0.5 lw 1.5 lc rgb '{3}'",
        plot.empty() ? "plot " : ", \\\n  ", lane, -lane, series_colour(static_cast<size_t>(lane)));
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", gnuplot_text(key_of(c)), -lane);
    ++lane;
  }
  text += fmt::format("set yrange [{}:1]\nset ytics ({})\n", 0.5 - lane, names);
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
    for (int family = 0; family < kFamilies; ++family)
      text += fmt::format("\t{}", 100 * family_shares(c, family).wrong);
    text += "\n";
  }
  text += "EOD\nplot ";
  for (int family = 0; family < kFamilies; ++family)
    text += fmt::format("{}$D using {}:xtic(1) lc rgb '{}' title 'family {}'", family == 0 ? "" : ", ", family + 2,
                        series_colour(static_cast<size_t>(family)), "ABC"[family]);
  return text + "\n";
}

}  // namespace gbl::stability

namespace gbl {

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

}  // namespace gbl
