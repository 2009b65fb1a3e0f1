#pragma once
// The axes: every choice a setting can take, one table of rows per enum. A row's index is the enum's value.
// The UI's combos, the command line, JSON, the docs' tables and the tests all follow from these rows.
#include <cstddef>
#include <span>
#include <string_view>

#include "renderer/base/features.h"

namespace gbl {

struct ValueRow {
  int value;                 // == its index; checked at compile time
  const char* id;            // kebab-case; a promise: changing one is a CHANGELOG line
  const char* label;         // for the screen
  const char* help;          // one line: what it does
  const char* cost = "";     // bits, bytes or pairs it costs; empty = nothing beyond the axis' other rows
  const char* source = "";   // author, year, title
  const char* pitfall = "";  // empty = sound; else the failure of the catalogue that this row shows
  Feature needs = Feature::none;

  constexpr bool sound() const { return pitfall[0] == '\0'; }
};

// ---- what is true -----------------------------------------------------------------------------------------
enum class LightSource { scene, generated, rig };
enum class LightSpot { cone, cos_power };
enum class LightMarkers { off, on };
enum class Attenuation { none, linear, quadratic, ramp, inverse_linear, windowed };
enum class RangeKind { source, threshold, windowed, none };
enum class ShadingModel { lambert, phong, blinn_phong, ggx };
enum class BackgroundFill { black, grey, colour, sky };
enum class NormalMap { on, off };
enum class AlbedoSource { textured, white };
enum class Colour { srgb, as_tutorial };

// ---- how it is drawn --------------------------------------------------------------------------------------
enum class Layout {
  albedo_roughness,
  nclgl,
  stereo,
  learnopengl,
  objectid,
  viewspace,
  compact,
  compact_metal,
  exact,
  exact_emission,
  float32,
  auto_
};
enum class NormalEncoding {
  xyz8,
  xyz8_raw,
  xyz10,
  xyz16f,
  xyz32f,
  bestfit8,
  stereo16f,
  lambert16,
  spherical16,
  oct8,
  oct10,
  oct12,
  oct14,
  oct16,
  oct16_precise,
  xy_sqrt
};
enum class NormalSpace { world, view };
enum class PositionSource { depth, linear32f, world16f, world32f, view16f, view32f, view_scaled };
enum class PositionReconstruct { view_ray, inverse_viewproj, inverse_viewproj_varying };
enum class DepthFormat { d16, d24, d32f, d32f_reversed };
enum class LightMethod {
  forward,
  forward_prepass,
  forward_multipass,
  prepass,
  fullscreen,
  fullscreen_radius,
  volumes,
  volumes_instanced,
  volumes_stencil,
  quads,
  disc,
  tiled,
  clustered,
  auto_
};
enum class LightCull { flip, back, none, front, flip_safe };
enum class VolumeLevel { l0, l1, l2, l3, l4 };
enum class VolumeFit { inscribed, circumscribed };
enum class VolumeClip { none, planes };
enum class VolumeDepth { none, less_equal, greater_equal };
enum class AccumulationFormat { rgba8, r11g11b10f, rgba16f, rgba32f };
enum class AccumulationTargets { one, split };
enum class BackgroundSkip { depth, stencil, alpha, none };
enum class Tangents { vertex, derivatives, matrix_columns };
enum class Antialias { none, edge_blur, msaa_resolved };
enum class DrawOrder { near_far, far_near, seeded };

// ---- what is looked at ------------------------------------------------------------------------------------
enum class VolumeOverlay { off, picked, all };
enum class ErrorOf { final, lit, diffuse_light, specular_light, normal, position, depth, albedo, roughness };
enum class ErrorScale { magnitude, with_sign };

// The table of an enum; specialised in axes.cpp's rows, reached only through rows<E>().
template <class E>
std::span<const ValueRow> rows();

template <class E>
const ValueRow& row(E value) {
  return rows<E>()[static_cast<size_t>(value)];
}

// Index of the row with this id; an unknown id is an Error naming `where` that lists the known ones.
int parse_id(std::span<const ValueRow> table, std::string_view id, std::string_view where);

}  // namespace gbl
