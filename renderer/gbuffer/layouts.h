#pragma once
// The layouts: how the material is packed, and what that keeps and loses. Rows: layouts.inc.
#include <span>
#include <string>

#include "renderer/gbuffer/attachment.h"
#include "renderer/rows/value_row.h"

namespace gbl {

enum class Layout {
#define LAYOUT(name, ...) name,
#include "renderer/gbuffer/layouts.inc"
#undef LAYOUT
};

// What the panel of key 5 shows of a layout.
enum class MaterialView { roughness, specular, nothing };

// What a scene's materials have beside albedo and roughness.
enum class MaterialHas {
  nothing,
  emission,
  specular,  // a reflectance of their own
  more       // metal, emission or occlusion
};

// The layout that takes the place of one that would leave out what the scene's materials have.
struct Successor {
  MaterialHas when = MaterialHas::nothing;
  Layout layout{};
};

// An attachment of the geometry pass; none where it has no name.
struct MaterialTexel {
  const char* name = nullptr;
  Stores stores{};
  Format format{};
  const char* contents = nullptr;
};
// What can be read back of a material, besides albedo, roughness and emission.
struct Keeps {
  bool reflectance = false, metal = false, occlusion = false, ambient = false, exponent = false;
};
inline constexpr int kMostMaterialTexels = 5;

struct LayoutRow {
  ValueRow axis;
  MaterialView shows = MaterialView::roughness;
  Stores shows_stored = Stores::material;
  const char* roughness_missing = "";
  bool words = false;   // the material is packed into integers
  bool floats = false;  // as floats; deferred lighting's thin G-buffer, too
  bool keeps_emission = false;
  Keeps keeps{};
  bool alpha_marks = false;      // alpha of the first attachment is 1 where a surface is
  bool begins_sum = false;       // ambient light and emission are written with the material: into the sum of light
  int normal_bits = 0;           // free in the material's first word, for a normal that fits
  Successor successors[2] = {};  // in the order in which they are asked
  MaterialTexel material[kMostMaterialTexels] = {};

  bool stores_roughness() const { return roughness_missing[0] == '\0'; }
};
const LayoutRow& facts(Layout);

// Is the layout only ever drawn in the place of another?
bool succeeds_another(Layout);

// Its file below shaders/. Deferred lighting packs its thin G-buffer by one file whatever the layout.
std::string shader_of(Layout);
inline constexpr const char* kThinLayoutShader = "layouts/thin.glsl";

}  // namespace gbl
