#pragma once
// Sets of figures that are made from other data of the lab, beside those of assets/figures.
#include "renderer/figures/figure_spec.h"
#include "renderer/lessons/lessons.h"

namespace gbl {

struct FigureSetRow {
  std::string name, title;
};
std::vector<FigureSetRow> figure_sets();  // for messages and `list figures`

// "pitfalls", a name of figure_sets(), or a file.
FigureSet figures_named(const std::string&);

// A figure for each step: what the window shows there.
FigureSet figures_of(const Lesson&);

}  // namespace gbl
