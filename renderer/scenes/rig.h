#pragma once
// Lighting rigs: lights in a file of their own, for any scene.
//   {"version": 1, "lights": [
//     {"kind": "point", "position": [0, 2, 0], "colour": [1, 0.9, 0.8], "candela": 40, "range": 6},
//     {"kind": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "candela": 100, "inner_deg": 20, "outer_deg": 30},
//     {"kind": "directional", "direction": [0.3, -1, 0.2], "lux": 2, "attenuation": [1, 0.7, 1.8]}]}
// Metres, linear RGB, half-angles. Without a range a light ends where its radiance on white falls
// to 1/255 of what the display shows as white.
// "attenuation": the light's own falloff 1/(a + b d + c d^2).
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

std::vector<Light> parse_rig(std::string_view json, std::string_view where);  // Error with light and member

// Of the file; read again when it changes.
std::vector<Light> rig_lights(const std::string& file);
long long rig_stamp(const std::string& file);  // changes when the file does; 0 if there is none

}  // namespace gbl
