// Counting pairs: variants of their own, so that what is timed is not slowed.
#include <algorithm>
#include <glm/glm.hpp>

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

void draw_counts(Frame& frame) {
  Targets& targets = frame.targets();
  if (frame.resolved.shading == Shading::forward)
    draw_forward(frame, LightOutput::count, clear_counts(targets.canvases.counts_with_depth(targets.frame)));
  else
    draw_lighting(frame, LightOutput::count, targets.canvases.counts(targets.frame).framebuffer);
}

// The lights of a frame, and what its method reads of them.
void bring_lights(Frame& frame) {
  upload_lights(frame);
  if (frame.resolved.shading != Shading::forward) prepare_lighting(frame);
}

}  // namespace

std::vector<int> Renderer::times_shaded(const std::vector<int>& lights, glm::ivec2 pixel, const Settings& s,
                                        const GpuScene& scene, Targets& targets) {
  std::vector<int> times;
  for (const int light : lights) {
    Settings alone = s;
    alone.lights.only = light;
    Frame frame = frame_of(alone, scene, targets);
    bring_lights(frame);
    draw_counts(frame);
    gl::AsyncTexels read;
    const gl::Texture* const counts[] = {&targets.canvases.counts().texture};
    read.start(counts, {pixel.x, s.size.y - 1 - pixel.y});
    constexpr size_t kInRange = 2;
    times.push_back(static_cast<int>(glm::uintBitsToFloat(read.take(true)->at(0)[kInRange])));
  }
  Frame frame = frame_of(s, scene, targets);
  bring_lights(frame);
  targets.canvases.counts_valid = false;
  return times;
}

namespace {

void draw_counts_lit(Frame& frame) {
  begin_drawing(frame.targets().canvases.counts_lit().framebuffer, frame.settings.size, {});
  bind_gbuffer(frame);
  bind_lights(frame);
  glUseProgram(frame.programs.get("fullscreen.vert", "count_lit.frag", frame.defines()).id());
  frame.shapes.draw_fullscreen();
}

}  // namespace

void Renderer::count_picked(const Settings& s, const GpuScene& scene, Targets& targets) {
  const int total = targets.drawn->light_total;
  Settings alone = s;
  if (total > 0)
    alone.lights.only = std::min(s.view.pick, total - 1);
  else
    alone.lights.first = 0;
  Frame frame = frame_of(alone, scene, targets);
  bring_lights(frame);
  draw_counts(frame);
  draw_counts_lit(frame);
  Frame all = frame_of(s, scene, targets);
  bring_lights(all);
  targets.canvases.counts_valid = targets.canvases.counts_lit_valid = false;
}

void Renderer::count_for(View view, const Settings& s, const GpuScene& scene, Targets& targets) {
  const ViewRow& r = row(view);
  if (!r.counted) return;
  const Canvases& c = targets.canvases;
  if (r.picked)
    count_picked(s, scene, targets);
  else if (!c.counts_valid || (r.against_lit && !c.counts_lit_valid))
    count_pairs(s, scene, targets, r.against_lit);
}

void Renderer::count_pairs(const Settings& s, const GpuScene& scene, Targets& targets, bool lit_too) {
  Frame frame = frame_of(s, scene, targets);
  Canvases& canvases = targets.canvases;
  const gl::PassScope scope(targets.timers, "count");
  draw_counts(frame);
  if (lit_too)
    draw_counts_lit(frame);
  else
    clear_counts(canvases.counts_lit().framebuffer);
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
