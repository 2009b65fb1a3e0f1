#pragma once
// The layouts: how the material is packed, and what that keeps and loses. Rows: layouts.inc.
#include <span>

#include "renderer/rows/value_row.h"
#include "renderer/gbuffer/attachment.h"

namespace gbl {

enum class Layout {
#define LAYOUT(name, ...) name,
#include "renderer/gbuffer/layouts.inc"
#undef LAYOUT
};

// What the panel of key 5 shows of a layout.
enum class MaterialView { roughness, specular, nothing };

// An attachment of the geometry pass; none where it has no name.
struct MaterialTexel {
  const char* name = nullptr;
  Stores stores{};
  Format format{};
  const char* contents = nullptr;
};
inline constexpr int kMostMaterialTexels = 5;

struct LayoutRow {
  ValueRow axis;
  MaterialView shows;
  bool srgb_coded_albedo;
  const char* roughness_missing = "";
  bool words = false;  // the material is packed into integers
  bool keeps_emission = false;
  bool alpha_marks = false;  // alpha of the first attachment is 1 where a surface is
  MaterialTexel material[kMostMaterialTexels] = {};

  bool stores_roughness() const { return roughness_missing[0] == '\0'; }
};
const LayoutRow& facts(Layout);

}  // namespace gbl
