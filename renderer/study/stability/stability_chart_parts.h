#pragma once
// What the charts of stability curves are put together from: texts for gnuplot, and the two kinds of chart that
// are not lines.
#include "renderer/study/charts/gnuplot.h"
#include "renderer/study/stability/stability_chart.h"

namespace gbl::stability {

std::string quoted_lines(const std::string&);  // the same of a text of several lines
std::string titled(const std::string& label, const std::string& unit);
std::string wrapped(const std::string&, size_t width);  // broken at spaces into lines of about equal length
std::string key_of(const CurveResult&);                 // the curve's id, and whether its statements hold

bool is_share(const SweepMetric&);  // its ticks are in %

// Shares that are nearly all 0 or 1 would lie on one another: every curve gets a lane of its own.
bool all_or_nothing(const SweepResult&);
std::string lanes_text(const SweepResult&);
std::string families_text(const SweepResult&);  // bars

}  // namespace gbl::stability
