#pragma once
// Falloff of light with distance, in double; the same formulas as shaders/attenuation.glsl, written apart.
#include "renderer/light/light_axes.h"

namespace gbl {

// 0..1 (windowed: up to 10^4, gltf: 10^8) at distance d from a light whose profile has range r; both in world units, r > 0.
double attenuation_at(Attenuation, double d, double r);

// The distance at which `strength` times the profile has fallen to `threshold`. A profile that never gets there within
// 10^6 r ends at r.
double range_at_threshold(Attenuation, double strength, double r, double threshold);

// Source 4's shortcut for the same (the mistake `range-shortcut`): radius * sqrt(strength / threshold - 0.2).
double range_by_shortcut(double strength, double r, double threshold);

}  // namespace gbl
