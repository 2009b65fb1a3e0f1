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

struct MethodRow {
  LightMethod method;
  int (*draw)(const LightingPass&);  // framebuffer bound and cleared, blending on; -> draw calls
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
};

}  // namespace gbl
