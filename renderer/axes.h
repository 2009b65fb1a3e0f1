#pragma once
// The axes: every choice a setting can take, one table of rows per enum. A row's index is the enum's value.
// The UI's combos, the command line, JSON, the docs' tables and the tests all follow from these rows.
#include <cstddef>
#include <span>
#include <string_view>

#include "renderer/features.h"

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
enum class LightSpot { cone };
enum class Attenuation { none, linear, quadratic, ramp, inverse_linear, windowed };
enum class RangeKind { source };
enum class ShadingModel { lambert, phong, blinn_phong, ggx };
enum class BackgroundFill { black, grey, colour, sky };
enum class NormalMap { on, off };
enum class AlbedoSource { textured, white };
enum class Colour { srgb, as_tutorial };

// ---- how it is drawn --------------------------------------------------------------------------------------
enum class Layout { albedo_roughness, nclgl, float32 };
enum class NormalEncoding { oct16, oct8, xyz8, stereo16f };
enum class NormalSpace { world };
enum class PositionSource { depth };
enum class PositionReconstruct { view_ray, inverse_viewproj };
enum class DepthFormat { d16, d24, d32f };
enum class LightMethod { fullscreen, fullscreen_radius, volumes, quads, disc, tiled, clustered, auto_ };
enum class LightCull { flip, back, none, front, flip_safe };
enum class VolumeLevel { l0, l1, l2, l3, l4 };
enum class VolumeFit { inscribed, circumscribed };
enum class VolumeClip { none, planes };
enum class VolumeDepth { none };
enum class AccumulationFormat { rgba8, r11g11b10f, rgba16f, rgba32f };
enum class AccumulationTargets { one, split };
enum class BackgroundSkip { depth };
enum class Tangents { vertex };
enum class Antialias { none };
enum class DrawOrder { near_far };

// ---- what is looked at ------------------------------------------------------------------------------------
enum class VolumeOverlay { off, picked, all };

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
