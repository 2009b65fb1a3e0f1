#pragma once
// Colours for numbers: stops at equal steps, display-coded.
#include <glm/glm.hpp>
#include <span>

namespace gbl {

// Black over violet to light yellow, evenly growing lightness (Smith and van der Walt 2015, matplotlib).
std::span<const glm::vec3> magma();

// Blue below, white at 0, red above (Brewer 2002, ColorBrewer: RdBu, 11 classes, turned round).
std::span<const glm::vec3> red_blue();

}  // namespace gbl
