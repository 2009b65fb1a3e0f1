#pragma once
// Figures that are drawn and not rendered: SVG, one row each.
#include <span>
#include <string>
#include <string_view>

#include "renderer/options/settings.h"

namespace gbl {

struct FigureDrawing {
  const char* id;
  const char* help;
  std::string (*svg)(const Settings&, const std::string& title);  // SVG 1.1
};
std::span<const FigureDrawing> figure_drawings();
const FigureDrawing& figure_drawing(std::string_view id);  // Error with the known ones

}  // namespace gbl
