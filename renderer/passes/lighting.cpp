#include "renderer/passes/lighting.h"

namespace gbl {

gl::Defines LightingPass::defines() const {
  gl::Defines d = frame.defines();
  d.push_back({"OUTPUT", static_cast<int>(output)});
  return d;
}

namespace {

void copy_depth(const Frame& frame, const gl::Framebuffer& into) {
  const glm::ivec2 size = frame.settings.size;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.targets.framebuffer(Pass::geometry).id());
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, into.id());
  constexpr GLint kUnmarked = 0;
  if (needs_stencil(frame.settings)) glClearBufferiv(GL_STENCIL, 0, &kUnmarked);
}

}  // namespace

int draw_lighting(const Frame& frame, LightOutput output, const gl::Framebuffer& into) {
  begin_drawing(into, frame.settings.size, {.blend = gl::Blend::add});
  const int targets = output == LightOutput::split ? 2 : 1;
  constexpr float kDark[] = {0, 0, 0, 0};
  for (int i = 0; i < targets; ++i) glClearBufferfv(GL_COLOR, i, kDark);
  if (lighting_tests_depth(frame.settings)) copy_depth(frame, into);
  if (frame.targets.lights.empty()) return 0;
  bind_gbuffer(frame);
  bind_lights(frame);
  return kMethods[static_cast<int>(frame.settings.lights.method)].draw({frame, output});
}

}  // namespace gbl
