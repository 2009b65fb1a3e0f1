#pragma once
// The axes of lights: where they come from, how they fall off, which pairs of pixel and light are shaded. One table of
// rows per enum; a row's index is the enum's value.
#include "renderer/rows/value_row.h"

namespace gbl {

enum class LightSource { scene, generated, rig };
enum class LightSpot { cone, cos_power };
enum class LightMarkers { off, on };
enum class Attenuation { none, linear, quadratic, ramp, inverse_linear, windowed, gltf };
enum class RangeKind { source, threshold, windowed, none };
enum class LightCull { flip, back, none, front, flip_safe };
enum class VolumeLevel { l0, l1, l2, l3, l4 };
enum class VolumeFit { inscribed, circumscribed };
enum class VolumeClip { none, planes };
enum class VolumeDepth { none, less_equal, greater_equal };

}  // namespace gbl
