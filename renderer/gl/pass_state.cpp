#include "renderer/gl/pass_state.h"

#include <epoxy/gl.h>

#include "renderer/gl/device.h"

namespace gbl::gl {
namespace {
void enable(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

constexpr GLenum kDepthFunctions[] = {GL_ALWAYS, GL_LESS, GL_LEQUAL, GL_EQUAL, GL_GREATER, GL_GEQUAL};
}  // namespace

void apply_cull(Cull cull) {
  enable(GL_CULL_FACE, cull != Cull::off);
  glCullFace(cull == Cull::front ? GL_FRONT : GL_BACK);
}

void apply_winding(Winding w) { glFrontFace(w == Winding::clockwise ? GL_CW : GL_CCW); }

void apply(const PassState& s) {
  // GL ignores depth writes while the test is off.
  enable(GL_DEPTH_TEST, s.depth != DepthTest::off || s.depth_write);
  glDepthFunc(kDepthFunctions[static_cast<int>(s.depth)]);
  glDepthMask(s.depth_write);
  apply_winding(Winding::counter_clockwise);
  apply_cull(s.cull);
  enable(GL_BLEND, s.blend != Blend::off);
  glBlendEquation(GL_FUNC_ADD);
  if (s.blend == Blend::alpha)
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  else
    glBlendFunc(GL_ONE, GL_ONE);
  glColorMask(true, true, true, true);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_COLOR_LOGIC_OP);
  if (device().features.has(Feature::depth_clamp)) enable(GL_DEPTH_CLAMP, s.depth_clamp);
  if (device().features.has(Feature::clip_control))
    glClipControl(GL_LOWER_LEFT, s.zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  glDepthRange(0, 1);
  glDisable(GL_DITHER);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glDisable(GL_SAMPLE_COVERAGE);
  glDisable(GL_RASTERIZER_DISCARD);
  glDisable(GL_FRAMEBUFFER_SRGB);  // the display transform is ours
  glDisable(GL_PRIMITIVE_RESTART);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  for (unsigned unit = 0; unit < 24; ++unit) glBindSampler(unit, 0);
}

}  // namespace gbl::gl
