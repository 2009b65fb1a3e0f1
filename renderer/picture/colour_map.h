#pragma once
// Colours for numbers: stops at equal steps, display-coded.
#include <glm/glm.hpp>
#include <span>

#include "renderer/rows/value_row.h"

namespace gbl {

// How a view turns one number into a colour. `own`: as the view does by itself.
enum class ColourMap { own, grey, viridis, magma, turbo, diverging };

// Of `own` there are none.
std::span<const glm::vec3> stops_of(ColourMap);

// t in 0..1 along the stops.
glm::vec3 colour_at(std::span<const glm::vec3> stops, double t);

}  // namespace gbl
