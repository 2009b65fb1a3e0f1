#include "renderer/gl/pass_state.h"

#include "renderer/gl/device.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/texture_units.h"

namespace gbl::gl {
namespace {
void enable(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

constexpr GLenum kDepthFunctions[] = {GL_ALWAYS, GL_LESS, GL_LEQUAL, GL_EQUAL, GL_GREATER, GL_GEQUAL};

struct StencilRow {
  Stencil stencil;
  GLenum test;  // of the stored value's `mask` bits, with `reference`'s
  GLint reference;
  GLuint mask, written;              // bits that are compared, and that are changed
  GLenum front_hidden, back_hidden;  // what happens where the depth test fails
  GLenum drawn;                      // … and where nothing fails
};
constexpr StencilRow kStencils[] = {
    {Stencil::off, GL_ALWAYS, 0, 0xff, 0xff, GL_KEEP, GL_KEEP, GL_KEEP},
    {Stencil::mark_surface, GL_ALWAYS, 0x80, 0x80, 0x80, GL_KEEP, GL_KEEP, GL_REPLACE},
    {Stencil::only_surfaces, GL_EQUAL, 0x80, 0x80, 0, GL_KEEP, GL_KEEP, GL_KEEP},
    {Stencil::count_hidden, GL_ALWAYS, 0, 0x7f, 0x7f, GL_DECR_WRAP, GL_INCR_WRAP, GL_KEEP},
    {Stencil::take_marked, GL_NOTEQUAL, 0, 0x7f, 0x7f, GL_KEEP, GL_KEEP, GL_ZERO},
};

void apply_stencil(Stencil stencil) {
  const StencilRow& r = kStencils[static_cast<int>(stencil)];
  enable(GL_STENCIL_TEST, r.stencil != Stencil::off);
  glStencilFunc(r.test, r.reference, r.mask);
  glStencilMask(r.written);
  glStencilOpSeparate(GL_FRONT, GL_KEEP, r.front_hidden, r.drawn);
  glStencilOpSeparate(GL_BACK, GL_KEEP, r.back_hidden, r.drawn);
}
}  // namespace

void apply_cull(Cull cull) {
  enable(GL_CULL_FACE, cull != Cull::off);
  glCullFace(cull == Cull::front ? GL_FRONT : GL_BACK);
}

void apply_winding(Winding w) { glFrontFace(w == Winding::clockwise ? GL_CW : GL_CCW); }

void change(const PassState& s) {
  // GL ignores depth writes while the test is off.
  enable(GL_DEPTH_TEST, s.depth != DepthTest::off || s.depth_write);
  glDepthFunc(kDepthFunctions[static_cast<int>(s.depth)]);
  glDepthMask(s.depth_write);
  apply_cull(s.cull);
  enable(GL_BLEND, s.blend != Blend::off);
  if (s.blend == Blend::alpha)
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  else if (s.blend == Blend::add_colour)
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
  else
    glBlendFunc(GL_ONE, GL_ONE);
  glColorMask(s.colour_write, s.colour_write, s.colour_write, s.colour_write);
  apply_stencil(s.stencil);
  if (device().features.has(Feature::depth_clamp)) enable(GL_DEPTH_CLAMP, s.depth_clamp);
  if (device().features.has(Feature::clip_control))
    glClipControl(GL_LOWER_LEFT, s.zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

static void state_what_only_one_api_has() {
  if (device().api == Api::es3) return glDepthRangef(0, 1);
  glDepthRange(0, 1);
  glDisable(GL_COLOR_LOGIC_OP);
  glDisable(GL_FRAMEBUFFER_SRGB);  // the display transform is ours
  glDisable(GL_PRIMITIVE_RESTART);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void let_shaders_size_points(bool on) {
  if (device().api == Api::core) enable(GL_PROGRAM_POINT_SIZE, on);  // in GLES they always do
}

void clip_at_plane(bool on) {
  if (device().api == Api::core) enable(GL_CLIP_DISTANCE0, on);
}

void apply(const PassState& s) {
  change(s);
  apply_winding(Winding::counter_clockwise);
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DITHER);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glDisable(GL_SAMPLE_COVERAGE);
  glDisable(GL_RASTERIZER_DISCARD);
  state_what_only_one_api_has();
  for (int unit = 0; unit < units_in_use(); ++unit) glBindSampler(static_cast<GLuint>(unit), 0);
}

}  // namespace gbl::gl
