#include "renderer/passes/lighting.h"

namespace gbl {
gl::Defines LightingPass::defines() const {
  gl::Defines d = frame.defines();
  // Counts are of pixels with geometry, whatever else is shaded.
  if (output == LightOutput::count)
    for (gl::Define& define : d)
      if (define.name == "BACKGROUND_SKIP") define = {"BACKGROUND_SKIP", static_cast<int>(BackgroundSkip::depth)};
  d.push_back({"OUTPUT", static_cast<int>(output)});
  if (output == LightOutput::lit) d.push_back({"SKY", frame.settings.background.fill == BackgroundFill::sky});
  return d;
}

namespace {

void copy_depth(const Frame& frame, const gl::Framebuffer& into) {
  const glm::ivec2 size = frame.settings.size;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.framebuffer(Pass::geometry).id());
  // With the stencil: its marks of surfaces are wanted here, and the other bits are 0.
  const GLbitfield stencil = frame.resolved.stencil ? GL_STENCIL_BUFFER_BIT : 0u;
  glDepthMask(true);
  glStencilMask(0xff);
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_DEPTH_BUFFER_BIT | stencil, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, into.id());
}

}  // namespace

int draw_lighting(const Frame& frame, LightOutput output, const gl::Framebuffer& into) {
  const gl::PassState state{.blend = gl::Blend::add, .stencil = light_stencil(frame)};
  begin_drawing(into, frame.settings.size, state);
  const int targets = output == LightOutput::split ? 2 : 1;
  const bool begun = output == LightOutput::sum && frame.resolved.light_sum_is_begun;
  const bool grey = output != LightOutput::count && frame.resolved.mistaken(Mistake::light_target_grey_clear);
  const glm::vec4 clear = grey ? glm::vec4(frame.background(), 1) : glm::vec4(0);
  for (int i = 0; i < targets && !begun; ++i) glClearBufferfv(GL_COLOR, i, &clear[0]);
  if (frame.resolved.lighting_has_depth) copy_depth(frame, into);
  gl::change(state);
  if (frame.lights().empty()) return 0;
  bind_gbuffer(frame);
  bind_lights(frame);
  return method_of(frame).draw({frame, output});
}

int prepare_lighting(Frame& frame) {
  return method_of(frame).prepare && !frame.lights().empty() ? method_of(frame).prepare(frame) : 0;
}

int draw_folded_light(Frame& frame) {
  const int prepared = prepare_lighting(frame);
  begin_drawing(frame.framebuffer(Pass::combine), frame.settings.size, {});
  bind_gbuffer(frame);
  bind_lights(frame);
  const LightingPass pass{frame, LightOutput::lit};
  return prepared + (frame.lights().empty() ? draw_fullscreen_lights(pass) : method_of(frame).draw(pass));
}

int draw_light_sums(Frame& frame) {
  const int prepared = prepare_lighting(frame);  // building lists is part of what a method costs
  return prepared + draw_lighting(frame, frame.resolved.split ? LightOutput::split : LightOutput::sum,
                                  frame.framebuffer(Pass::lighting));
}

}  // namespace gbl
