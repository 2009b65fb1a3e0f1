// One rectangle per light, its exact bounds on screen, all in one draw without any vertex buffer.
#include "renderer/passes/lighting.h"

namespace gbl {

int draw_quad_lights(const LightingPass& pass) {
  const Frame& frame = pass.frame;
  glUseProgram(frame.programs.get("light_quads.vert", "light_volume.frag", pass.defines()).id());
  frame.shapes.draw_generated(6, frame.light_count());
  return 1;
}

}  // namespace gbl
