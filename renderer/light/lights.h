#pragma once
// Generated lights, as pure functions of place, count, seed and time.
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

// N lights on the scene's grid at time_s; range_scale applied; any N from 0 works (one light stands on the axis).
std::vector<Light> generated_lights(const LightGrid&, int count, unsigned seed, double time_s);

// N lights in a box; the first k of N are the first k of any larger N, but for an overlap's range. They stand still.
std::vector<Light> generated_lights(const LightBox&, int count, unsigned seed);

}  // namespace gbl
