#include "renderer/gbuffer/layouts.h"

#include <fmt/format.h>

#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

constexpr MaterialTexel kExactMaterial = {
    "gbuffer.material", Stores::material, Format::rg32ui,
    "r: base colour 10 10 10 sRGB-coded, roughness bits 0-1; g: roughness bits 2-13, metal 10, occlusion 10"};
constexpr MaterialTexel kExactEmission = {"gbuffer.emission", Stores::emission, Format::r32ui,
                                          "r: emission 11 11 10 sRGB-coded as displayed"};

#define LAYOUT(name, ...) {__VA_ARGS__},
constexpr LayoutRow kLayouts[] = {
#include "renderer/gbuffer/layouts.inc"
};
#undef LAYOUT
constexpr auto kValues = values_of<kLayouts>([](const LayoutRow& r) { return r.axis; });

}  // namespace

GBL_ROWS(Layout, kValues)

const LayoutRow& facts(Layout l) { return kLayouts[static_cast<int>(l)]; }

bool succeeds_another(Layout l) {
  for (const LayoutRow& r : kLayouts)
    for (const Successor& next : r.successors)
      if (next.when != MaterialHas::nothing && next.layout == l) return true;
  return false;
}

std::string shader_of(Layout l) { return fmt::format("layouts/{}.glsl", row(l).id); }

}  // namespace gbl
