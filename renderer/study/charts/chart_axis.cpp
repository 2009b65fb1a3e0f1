// Where a chart's axis begins and ends, where its ticks are, and where it puts a zero that has no place on it.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/study/charts/chart.h"

namespace gbl {
namespace {

constexpr int kMostTicks = 8;

// Rounded to ten digits, or 0.3 would be 0.30000000000000004.
std::string tick_label(double value, bool percent) {
  return percent ? fmt::format("{:.10g} %", 100 * value) : fmt::format("{:.10g}", value);
}

// 1, 2 or 5 times a power of ten.
double round_step(double at_least) {
  const double decade = std::pow(10, std::floor(std::log10(at_least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= at_least * (1 - 1e-9)) return factor * decade;
  return 10 * decade;
}

std::vector<ChartTick> linear_ticks(double low, double high, bool percent) {
  const double step = round_step((high - low) / kMostTicks);
  std::vector<ChartTick> ticks;
  for (double n = std::ceil(low / step); n * step <= high; ++n)  // counted, not summed
    ticks.push_back({n * step, tick_label(n == 0 ? 0 : n * step, percent)});
  return ticks;
}

// Decades, every so many of them where there are many; less than two decades have 2 and 5 as well.
std::vector<ChartTick> logarithmic_ticks(double low, double high, bool percent) {
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  const int every = (last - first) / kMostTicks + 1;
  const bool few = high / low < 100;
  std::vector<ChartTick> ticks;
  for (int decade = first; decade <= last; decade += every)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double at = factor * std::pow(10, decade);
      if ((factor == 1 || few) && at >= low && at <= high) ticks.push_back({at, tick_label(at, percent)});
    }
  // An axis of 3 to 4 has none of these.
  return ticks.size() < 2 ? linear_ticks(low, high, percent) : ticks;
}

}  // namespace

ChartAxis axis_for(const StudyColumn& column, const std::vector<double>& values) {
  ChartAxis axis{.logarithmic = !column.more_is_better, .percent = column.is_share()};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool zeros = false;
  for (const double v : values) {
    zeros |= axis.logarithmic && !(v > 0);
    if (axis.logarithmic && !(v > 0)) continue;
    low = std::min(low, v), high = std::max(high, v);
  }
  if (low > high) low = high = 1;  // nothing but zeros, or nothing at all
  if (zeros) low /= 10, axis.zero_at = low;
  constexpr double kBeyond = 1.4;  // so that no point sits on the frame
  const double pad = std::max(0.05 * (high - low), 1e-9 * std::abs(high) + 1e-12);
  axis.low = axis.logarithmic ? low / kBeyond : low - pad;
  axis.high = axis.logarithmic ? high * kBeyond : high + pad;
  return axis;
}

double ChartAxis::along(double value) const {
  const double at = place(value);
  if (std::isnan(at)) return 1;
  const double share =
      logarithmic ? std::log(std::max(at, low) / low) / std::log(high / low) : (at - low) / (high - low);
  return std::clamp(share, 0.0, 1.0);
}

std::vector<ChartTick> ticks_of(const ChartAxis& axis) {
  if (!axis.logarithmic) return linear_ticks(axis.low, axis.high, axis.percent);
  if (!axis.zero_at) return logarithmic_ticks(axis.low, axis.high, axis.percent);
  constexpr double kSmallest = 9.99;  // of zero_at: between 0 and the smallest value is nothing to read off
  std::vector<ChartTick> ticks = logarithmic_ticks(kSmallest * *axis.zero_at, axis.high, axis.percent);
  ticks.insert(ticks.begin(), {*axis.zero_at, "0"});
  return ticks;
}

}  // namespace gbl
