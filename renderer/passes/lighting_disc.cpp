// One flat disc per light, as source 4 draws it, but all in one draw.
#include "renderer/passes/lighting.h"

namespace gbl {

int draw_disc_lights(const LightingPass& pass) {
  constexpr int kSides = 36;
  const Frame& frame = pass.frame;
  gl::Defines defines = pass.defines();
  defines.push_back({"DISC_SIDES", kSides});
  glUseProgram(frame.programs.get("light_disc.vert", "light_volume.frag", defines).id());
  frame.shapes.draw_generated(3 * kSides, frame.light_count());
  return 1;
}

}  // namespace gbl
