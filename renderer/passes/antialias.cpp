// Edges smoothed after lighting: what a G-buffer with one sample per pixel leaves to do.
#include "renderer/passes/passes.h"

namespace gbl {

int draw_edge_blur(Frame& frame) {
  const glm::ivec2 size = frame.settings.size;
  const gl::Framebuffer& lit = frame.framebuffer(Pass::combine);
  Canvas& unblurred = frame.targets().canvases.unblurred();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, lit.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, unblurred.framebuffer.id());
  gl::apply({});
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  begin_drawing(lit, size, {});
  bind_gbuffer(frame);
  gl::bind_texture("lit", unblurred.texture);
  glUseProgram(frame.programs.get("fullscreen.vert", "edge_blur.frag", frame.defines()).id());
  frame.shapes.draw_fullscreen();
  return 1;
}

}  // namespace gbl
