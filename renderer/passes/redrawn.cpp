// Objects drawn once more, while somebody looks: how often pixels are written, which triangle is seen, what was culled.
#include "renderer/passes/frame_block.h"
#include "renderer/passes/objects.h"

namespace gbl {
namespace {

gl::Defines redrawn_defines(const Frame& frame, int what) {
  gl::Defines defines = frame.surface_defines();
  defines.push_back({"REDRAWN", what});
  if (what == REDRAWN_TRIANGLES) defines.push_back({"TRIANGLE_IDS", 1});
  return defines;
}

void begin(const Frame& frame, Canvas& into, const gl::PassState& state) {
  constexpr float kZero[4] = {};
  begin_drawing(into.framebuffer, frame.settings.size, depth_tested(frame, gl::DepthTest::less, state));
  glClearBufferfv(GL_COLOR, 0, kZero);
  clear_depth(frame);
}

}  // namespace

void draw_redrawn(Frame& frame) {
  Canvases& canvases = frame.targets().canvases;
  if (canvases.redrawn_valid) return;
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  begin(frame, canvases.redrawn_triangles(), {.depth_write = true});
  draw_objects(frame, draws, "redrawn.frag", redrawn_defines(frame, REDRAWN_TRIANGLES), {}, Corners::numbered);
  begin(frame, canvases.redrawn_counts(), {.depth_write = true, .blend = gl::Blend::add});
  draw_objects(frame, draws, "redrawn.frag", redrawn_defines(frame, REDRAWN_WRITTEN));
  gl::change(depth_tested(frame, gl::DepthTest::less, {.blend = gl::Blend::add}));
  draw_objects(frame, draws, "redrawn.frag", redrawn_defines(frame, REDRAWN_CULLED), {}, Corners::shared,
               ObjectFaces::culled);
  canvases.redrawn_valid = true;
}

}  // namespace gbl
