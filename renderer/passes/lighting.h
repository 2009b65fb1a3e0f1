#pragma once
// A method chooses which pixel-light pairs are shaded. A sound method chooses at least every pair in range, and none
// ever changes what a pair contributes: all share shade() in shaders/shade.glsl.
#include "renderer/passes/passes.h"

namespace gbl {

struct LightingPass {
  const Frame& frame;
  LightOutput output;
  gl::Defines defines() const;  // of the G-buffer and of the output
};

int draw_fullscreen_lights(const LightingPass&);
int draw_fullscreen_radius_lights(const LightingPass&);
int draw_volume_lights(const LightingPass&);
int draw_volume_lights_instanced(const LightingPass&);
int draw_volume_lights_stencil(const LightingPass&);
int draw_quad_lights(const LightingPass&);
int draw_disc_lights(const LightingPass&);
int draw_tiled_lights(const LightingPass&);
int prepare_clusters(Frame&);
int draw_clustered_lights(const LightingPass&);

inline constexpr int kTile = 16;  // pixels a side

struct MethodRow {
  LightMethod method;
  int (*draw)(const LightingPass&);  // framebuffer bound and cleared, blending on; -> draw calls
  int (*prepare)(Frame&) =
      nullptr;  // once per frame, before its light is drawn and its pairs are counted; -> draw calls
};
inline constexpr MethodRow kMethods[] = {
    {LightMethod::forward, nullptr},  // no light pass: see forward.cpp
    {LightMethod::forward_prepass, nullptr},
    {LightMethod::forward_multipass, nullptr},
    {LightMethod::prepass, draw_fullscreen_radius_lights},
    {LightMethod::fullscreen, draw_fullscreen_lights},
    {LightMethod::fullscreen_radius, draw_fullscreen_radius_lights},
    {LightMethod::volumes, draw_volume_lights},
    {LightMethod::volumes_instanced, draw_volume_lights_instanced},
    {LightMethod::volumes_stencil, draw_volume_lights_stencil},
    {LightMethod::quads, draw_quad_lights},
    {LightMethod::disc, draw_disc_lights},
    {LightMethod::tiled, draw_tiled_lights},
    {LightMethod::clustered, draw_clustered_lights, prepare_clusters},
    {LightMethod::auto_, nullptr},  // render() has replaced it by another
};
constexpr bool methods_in_order() {
  for (size_t i = 0; i < std::size(kMethods); ++i)
    if (kMethods[i].method != static_cast<LightMethod>(i)) return false;
  return true;
}
static_assert(methods_in_order());
inline const MethodRow& method_of(const Frame& f) { return kMethods[static_cast<size_t>(f.settings.lights.method)]; }

}  // namespace gbl
