#pragma once
// The axes of lights: where they come from, how they fall off, which pairs of pixel and light are shaded. One table of
// rows per enum; a row's index is the enum's value.
#include "renderer/rows/value_row.h"

namespace gbl {

enum class LightSource { scene, generated, rig };
enum class LightSpot { cone, cos_power };
enum class LightMarkers { off, on };
enum class Shadows { off, sun, all };
enum class Reflections { off, on };
enum class ReflectMethod { none, planar, cube };
enum class ReflectParallax { none, box };
enum class ReflectSize { s64, s128, s256, s512 };
enum class ShadowMapSize { s256, s512, s1024, s2048, s4096 };
enum class ShadowFormat { d16, d24, d32f };
enum class ShadowCull { none, back, front };
enum class ShadowFilter { none, bilinear, pcf3 };
enum class ShadowStable { off, on };
enum class ShadowPoint { axis, brute_force };
enum class ShadowReach { fitted, near_one };
enum class ShadowUpdate { changed, each_frame, once };
enum class Attenuation { none, linear, quadratic, ramp, inverse_linear, windowed, gltf };
enum class RangeKind { source, threshold, windowed, none };
enum class LightCull { flip, back, none, front, flip_safe };
enum class VolumeLevel { l0, l1, l2, l3, l4 };
enum class VolumeFit { inscribed, circumscribed };
enum class VolumeClip { none, planes };
enum class VolumeDepth { none, less_equal, greater_equal };

}  // namespace gbl
