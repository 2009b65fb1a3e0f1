// Transparent objects over the lit picture, farthest first. A G-buffer holds one surface per pixel, so what can be
// seen through has to be shaded apart (source 0 says so and leaves it out).
#include "renderer/passes/forward.h"

namespace gbl {
namespace {

int draw_markers(const Frame& frame, const gl::Framebuffer& into, gl::DepthTest test) {
  const auto lights = static_cast<GLsizei>(frame.lights().size());
  if (frame.settings.lights.markers == LightMarkers::off || lights == 0) return 0;
  const bool tested = test != gl::DepthTest::off;
  begin_drawing(into, frame.settings.size, depth_tested(frame, test, {.depth_write = tested, .cull = gl::Cull::back}));
  bind_lights(frame);
  glUseProgram(frame.programs.get("light_marker.vert", "light_marker.frag", frame.shaded_defines()).id());
  frame.shapes.draw_generated(36, lights);
  return 1;
}

}  // namespace

int draw_transparent(Frame& frame) {
  Canvases& canvases = frame.targets().canvases;
  Canvas& composed = canvases.composed(frame.targets().frame);
  const glm::ivec2 size = frame.settings.size;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.framebuffer(Pass::combine).id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, composed.framebuffer.id());
  glDisable(GL_SCISSOR_TEST);
  glColorMask(true, true, true, true);
  glDepthMask(true);
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.framebuffer(Pass::geometry).id());
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  canvases.composed_valid = true;
  if (frame.resolved.mistaken(Mistake::depth_cleared_before_lighting)) {
    glBindFramebuffer(GL_FRAMEBUFFER, composed.framebuffer.id());
    constexpr float kOfTheQuad = 0.5f;  // z = 0 of clip space, in every pixel
    glClearBufferfv(GL_DEPTH, 0, &kOfTheQuad);
  }
  const gl::DepthTest test =
      frame.resolved.mistaken(Mistake::forward_without_depth) ? gl::DepthTest::off : gl::DepthTest::less;
  const int markers = draw_markers(frame, composed.framebuffer, test);
  const std::vector<ObjectDraw> draws = prepare_objects(frame, true);
  begin_drawing(composed.framebuffer, size, depth_tested(frame, test, {.blend = gl::Blend::alpha}));
  return markers + draw_shaded_objects(frame, draws, {});
}

}  // namespace gbl
