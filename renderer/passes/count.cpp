// Counting pairs: variants of their own, so that what is timed is not slowed.
#include "renderer/passes/frame_block.h"
#include "renderer/passes/lighting.h"

namespace gbl {

namespace {

const gl::Framebuffer& clear_counts(const gl::Framebuffer& counts) {
  constexpr float kZero[4] = {};
  glBindFramebuffer(GL_FRAMEBUFFER, counts.id());
  glColorMask(true, true, true, true);
  glDisable(GL_SCISSOR_TEST);
  glClearBufferfv(GL_COLOR, 0, kZero);
  return counts;
}

}  // namespace

void Renderer::count_pairs(const Settings& s, const GpuScene& scene, Targets& targets, bool lit_too) {
  Frame frame = frame_of(s, scene, targets);
  Canvases& canvases = targets.canvases;
  const gl::PassScope scope(targets.timers, "count");
  if (frame.resolved.shading == Shading::forward)
    draw_forward(frame, LightOutput::count, clear_counts(canvases.counts_with_depth(targets.frame)));
  else
    draw_lighting(frame, LightOutput::count, canvases.counts(targets.frame).framebuffer);
  begin_drawing(canvases.counts_lit().framebuffer, s.size, {});
  if (lit_too) {
    bind_gbuffer(frame);
    bind_lights(frame);
    glUseProgram(programs_.get("fullscreen.vert", "count_lit.frag", frame.defines()).id());
    shapes_.draw_fullscreen();
  } else {
    constexpr float kZero[4] = {};
    glClearBufferfv(GL_COLOR, 0, kZero);
  }
  Canvas& sums = canvases.count_sums();
  begin_drawing(sums.framebuffer, sums.texture.size, {});
  gl::bind_texture("counts", canvases.counts().texture);
  gl::bind_texture("counts_lit", canvases.counts_lit().texture);
  glUseProgram(programs_.get("fullscreen.vert", "count_reduce.frag", {}).id());
  shapes_.draw_fullscreen();
  targets.reads.counts.start(sums.texture);
  canvases.counts_valid = true;
  canvases.counts_lit_valid = lit_too;
}

}  // namespace gbl
