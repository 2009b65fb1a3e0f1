// Opaque and masked objects into the G-buffer; and deferred lighting's second time over them.
#include "renderer/passes/objects.h"

namespace gbl {
namespace {

// With background.skip=none the clear colour of every attachment is what will be lit, as in the sources.
void clear_gbuffer(const Frame& frame) {
  int buffer = 0;
  const glm::vec4 clear =
      frame.settings.background.skip == BackgroundSkip::none ? glm::vec4(frame.background(), 1) : glm::vec4(0);
  for (const Attachment& a : frame.resolved.attachments) {
    constexpr GLuint kZeroCodes[4] = {};
    if (a.written_by != Pass::geometry || a.stores == Stores::depth) continue;
    if (row(a.format).numeric == Numeric::uint)
      glClearBufferuiv(GL_COLOR, buffer++, kZeroCodes);
    else
      glClearBufferfv(GL_COLOR, buffer++, &(a.stores == Stores::light ? glm::vec4(0) : clear)[0]);
  }
  clear_depth(frame);
}

}  // namespace

int draw_geometry(Frame& frame) {
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  const FrameTextures& t = frame.targets().frame;
  gl::PassState state{.depth_write = true};
  if (frame.resolved.mistaken(Mistake::blend_on_in_fill)) state.blend = gl::Blend::alpha;
  if (frame.settings.background.skip == BackgroundSkip::stencil) state.stencil = gl::Stencil::mark_surface;
  begin_drawing(t.geometry_framebuffer(), frame.settings.size, depth_tested(frame, gl::DepthTest::less, state));
  clear_gbuffer(frame);
  const int calls = draw_objects(frame, draws, "geometry.frag", frame.surface_defines());
  t.resolve_samples();
  return calls;
}

int draw_materials_over_light(Frame& frame) {
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  const gl::Framebuffer& lit = frame.framebuffer(Pass::combine);
  int calls = draw_background(frame, lit);
  begin_drawing(lit, frame.settings.size, depth_tested(frame, gl::DepthTest::equal, {}));
  bind_light_sums(frame);
  return calls + draw_objects(frame, draws, "light_prepass.frag", frame.surface_defines());
}

}  // namespace gbl
