#pragma once
// What the charts of stability curves are put together from: colours, texts for gnuplot, and the two kinds of chart that
// are not lines.
#include "renderer/study/charts/gnuplot.h"
#include "renderer/study/stability/stability_chart.h"

namespace gbl::stability {

// Okabe and Ito 2008, "Color Universal Design", without their yellow: too pale on white.
inline constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
// gnuplot's numbers: disc, square, triangles, diamond, pentagon; the same open; plus, cross, star. 13 shapes and 7
// colours have no common factor: 91 curves differ.
inline constexpr int kShapes[] = {7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14, 1};
std::string quoted_lines(const std::string&);  // the same of a text of several lines
std::string titled(const std::string& label, const std::string& unit);
std::string wrapped(const std::string&, size_t width);  // broken at spaces into lines of about equal length
std::string key_of(const CurveResult&);                 // the curve's id, and whether its statements hold

// Shares that are nearly all 0 or 1 would lie on one another: every curve gets a lane of its own.
bool all_or_nothing(const SweepResult&);
std::string lanes_text(const SweepResult&);
std::string families_text(const SweepResult&);  // bars

}  // namespace gbl::stability
