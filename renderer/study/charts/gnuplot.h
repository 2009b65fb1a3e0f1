#pragma once
// gnuplot as a function: script in, picture out. No shell is asked and no file is named in the script, so nothing in a
// study's label can be taken for a command.
#include <string>

#include "renderer/study/charts/chart.h"

namespace gbl {

// What gnuplot writes to its standard output. Error(unfinished): it is not installed (and which package has it), or it
// refused the script.
std::string run_gnuplot(const std::string& script);

// A text for a script, quotes included; control characters become spaces.
std::string gnuplot_text(const std::string&);

// How the n-th family of a chart looks: a colour, and a shape that is filled where sound and open where not. 7 colours and 6
// shapes meet again after 42 families; neighbours differ in both.
const char* series_colour(size_t n);
int series_shape(size_t n, bool sound);
// A line of the legend without a mark, for "plot".
std::string legend_heading(const std::string&);

struct ChartTexts {
  std::string title, subtitle;
};
enum class ChartFile { svg, png };

// Named axes with units, families by colour and shape, filled where sound and open where not, the Pareto front as a line,
// presets circled and named, zero on a row of its own.
std::string chart_script(const Chart&, const ChartTexts&, ChartFile);

}  // namespace gbl
