// Two pictures for the eye against each other.
#include "renderer/passes/passes.h"

namespace gbl {

void Renderer::draw_difference(const gl::Texture& a, const gl::Texture& b, const Canvas& into) {
  begin_drawing(into.framebuffer, a.size, {});
  gl::bind_texture("picture_a", a);
  gl::bind_texture("picture_b", b);
  glUseProgram(programs_.get("fullscreen.vert", "difference.frag", {}).id());
  shapes_.draw_fullscreen();
}

void Renderer::colour_difference(const gl::Texture& difference, ErrorScale scale, double range, const Canvas& into) {
  begin_drawing(into.framebuffer, difference.size, {});
  colour_errors(programs_, shapes_, difference, scale, range);
}

}  // namespace gbl
