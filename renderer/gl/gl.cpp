#include "renderer/gl/gl.h"

#include <cstring>

namespace gbl::gl {

#ifdef __EMSCRIPTEN__

bool is_desktop_gl() { return false; }
int gl_version() { return 30; }
bool has_extension(const char* name) { return web::enable_extension(name + std::strlen("GL_")); }

GLenum renderer_query() {
  constexpr GLenum kUnmasked = 0x9246;  // WEBGL_debug_renderer_info
  return has_extension("GL_WEBGL_debug_renderer_info") ? kUnmasked : GL_RENDERER;
}

// Nothing is signalled before a frame has ended, and whoever reads waits for what is read.
GLenum state_of(GLsync fence, bool wait) {
  return wait ? GLenum(GL_CONDITION_SATISFIED) : glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
}

bool read_bound_buffer(GLenum target, void* to, size_t bytes) {
  web::read_buffer(target, to, bytes);
  return true;
}

#else

bool is_desktop_gl() { return epoxy_is_desktop_gl(); }
int gl_version() { return epoxy_gl_version(); }
bool has_extension(const char* name) { return epoxy_has_gl_extension(name); }
GLenum renderer_query() { return GL_RENDERER; }

GLenum state_of(GLsync fence, bool wait) {
  constexpr GLuint64 kOneSecondNs = 1'000'000'000;
  GLenum state = GL_TIMEOUT_EXPIRED;
  do state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? kOneSecondNs : 0);
  while (wait && state == GL_TIMEOUT_EXPIRED);
  return state;
}

bool read_bound_buffer(GLenum target, void* to, size_t bytes) {
  const void* mapped = glMapBufferRange(target, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
  if (mapped) std::memcpy(to, mapped, bytes);
  return mapped && glUnmapBuffer(target);
}

#endif

}  // namespace gbl::gl
