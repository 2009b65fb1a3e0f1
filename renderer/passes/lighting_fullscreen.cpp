// One full-screen pass that loops over all lights: the plain loop, and the loop with a distance test.
#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

int draw_loop(const LightingPass& pass, bool radius_test) {
  gl::Defines defines = pass.defines();
  defines.push_back({"RADIUS_TEST", radius_test});
  glUseProgram(pass.frame.programs.get("fullscreen.vert", "light_fullscreen.frag", defines).id());
  pass.frame.shapes.draw_fullscreen();
  return 1;
}

}  // namespace

int draw_fullscreen_lights(const LightingPass& pass) { return draw_loop(pass, false); }
int draw_fullscreen_radius_lights(const LightingPass& pass) { return draw_loop(pass, true); }

}  // namespace gbl
