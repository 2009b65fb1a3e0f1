#include "renderer/passes/lighting.h"

namespace gbl {

gl::Defines LightingPass::defines() const {
  gl::Defines d = frame.defines();
  d.push_back({"OUTPUT", static_cast<int>(output)});
  return d;
}

int draw_lighting(const Frame& frame, LightOutput output, const gl::Framebuffer& into) {
  begin_drawing(into, frame.settings.size, {.blend = gl::Blend::add});
  const int targets = output == LightOutput::split ? 2 : 1;
  constexpr float kDark[] = {0, 0, 0, 0};
  for (int i = 0; i < targets; ++i) glClearBufferfv(GL_COLOR, i, kDark);
  if (frame.targets.lights.empty()) return 0;
  bind_gbuffer(frame);
  bind_lights(frame);
  return method_of(frame).draw({frame, output});
}

void prepare_lighting(const Frame& frame) {
  if (method_of(frame).prepare && !frame.targets.lights.empty()) method_of(frame).prepare(frame);
}

}  // namespace gbl
