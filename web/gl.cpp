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
// clang-format on

void clip_control(GLenum origin, GLenum depth) { gbl_clip_control(static_cast<int>(origin), static_cast<int>(depth)); }
void read_buffer(GLenum target, void* to, size_t bytes) {
  gbl_read_buffer(static_cast<int>(target), to, static_cast<int>(bytes));
}
bool enable_extension(const char* name) {
  return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name);
}

}  // namespace gbl::web
