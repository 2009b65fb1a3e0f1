#include "web/gl.h"

#include <cstdio>
#include <cstdlib>
#include <emscripten.h>
#include <emscripten/html5.h>

namespace gbl::web {

void missing(const char* function) {
  std::fprintf(stderr, "%s: WebGL has no such function\n", function);
  std::abort();
}

// clang-format off
EM_JS(void, gbl_clip_control, (int origin, int depth), {
  const extension = GLctx.getExtension('EXT_clip_control');
  if (extension) extension.clipControlEXT(origin, depth);
});
EM_JS(void, gbl_read_buffer, (int target, void* to, int bytes), {
  GLctx.getBufferSubData(target, 0, HEAPU8, to, bytes);
});
// Chromium takes finish() for a flush, so that no page can hold it up. What is read back has to be there.
EM_JS(void, gbl_finish, (), {
  const gl = GLctx;
  const draws = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING);
  const reads = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
  const packs = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
  if (!gl.gblAnchor) {
    gl.gblAnchor = gl.createFramebuffer();
    gl.gblTexel = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, gl.gblTexel);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, 1, 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.gblAnchor);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, gl.gblTexel);
    gl.canvas.addEventListener('webglcontextlost', () => { gl.gblAnchor = null; }, {once: true});
  }
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.gblAnchor);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, packs);
  gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, draws);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, reads);
});
// clang-format on

void finish() { gbl_finish(); }
void clip_control(GLenum origin, GLenum depth) { gbl_clip_control(static_cast<int>(origin), static_cast<int>(depth)); }
void read_buffer(GLenum target, void* to, size_t bytes) {
  gbl_read_buffer(static_cast<int>(target), to, static_cast<int>(bytes));
}
bool enable_extension(const char* name) {
  return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name);
}

}  // namespace gbl::web
