// Transparent objects over the lit picture, farthest first. A G-buffer holds one surface per pixel, so what can be
// seen through has to be shaded apart (source 0 says so and leaves it out).
#include "renderer/passes/forward.h"

namespace gbl {

int draw_transparent(const Frame& frame) {
  Targets& t = frame.targets;
  Canvas& composed = t.composed();
  const glm::ivec2 size = frame.settings.size;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, t.framebuffer(Pass::combine).id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, composed.framebuffer.id());
  glDisable(GL_SCISSOR_TEST);
  glColorMask(true, true, true, true);
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  const std::vector<ObjectDraw> draws = prepare_objects(frame, true);
  begin_drawing(composed.framebuffer, size, depth_tested(frame, gl::DepthTest::less, {.blend = gl::Blend::alpha}));
  t.composed_valid = true;
  return draw_shaded_objects(frame, draws, {});
}

}  // namespace gbl
