#include "renderer/passes/lighting.h"

namespace gbl {
namespace {
constexpr float kNothing[4] = {};
}

gl::Defines LightingPass::defines() const {
  gl::Defines d = frame.defines();
  d.push_back({"OUTPUT", static_cast<int>(output)});
  return d;
}

int draw_lighting(const Frame& frame, LightOutput output, const gl::Framebuffer& into) {
  begin_drawing(into, frame.settings.size, {.blend = gl::Blend::add});
  const int targets = output == LightOutput::split ? 2 : 1;
  const bool begun = output == LightOutput::sum && sum_begins_in_geometry(frame.settings);
  for (int i = 0; i < targets && !begun; ++i) glClearBufferfv(GL_COLOR, i, kNothing);
  if (frame.targets.lights.empty()) return 0;
  bind_gbuffer(frame);
  bind_lights(frame);
  return kMethods[static_cast<int>(frame.settings.lights.method)].draw({frame, output});
}

}  // namespace gbl
