#pragma once
// A figure from the window: its pixels as they are on screen, a caption below, and what brings them back inside.
#include <string>

#include "app/imgui_screen.h"
#include "renderer/study/rows/study_columns.h"

namespace gbl {

// From the back buffer of a window of this size, into out/figure-NNN-VIEW.png, with the caption as .md and .tex beside it; says where.
std::string save_figure(const ui::Figure&, glm::ivec2 window, ImguiScreen&, const Settings&, const Machine&);

}  // namespace gbl
