#pragma once
// OpenGL in a browser: WebGL 2 through Emscripten's GLES 3.0, the constants of OpenGL, and what WebGL has not. That is never called:
// the features that need it are missing there (renderer/gl/device.cpp).
#include <GLES3/gl3.h>
#include <cstddef>
typedef double GLdouble;  // which glext.h takes for granted
typedef double GLclampd;
#include <GL/glext.h>

// Of OpenGL 1, which glext.h leaves out.
#define GL_COLOR_LOGIC_OP 0x0BF2
#define GL_FILL 0x1B02
#define GL_PACK_SWAP_BYTES 0x0D00
#define GL_RGBA16 0x805B
#define GL_UNPACK_SWAP_BYTES 0x0CF0

namespace gbl::web {
[[noreturn]] void missing(const char* function);
void clip_control(GLenum origin, GLenum depth);  // EXT_clip_control
void read_buffer(GLenum target, void* to, size_t bytes);
bool enable_extension(const char* name);  // of the current context: is it there?
void finish();                            // waits, which a browser's own finish() does not
}  // namespace gbl::web

#define GBL_MISSING(name)       \
  template <class... Arguments> \
  void name(Arguments...) {     \
    gbl::web::missing(#name);   \
  }
GBL_MISSING(glBindImageTexture)
GBL_MISSING(glClampColor)
GBL_MISSING(glDepthRange)
GBL_MISSING(glDispatchCompute)
GBL_MISSING(glDrawTransformFeedback)
GBL_MISSING(glGetBufferSubData)
GBL_MISSING(glGetQueryObjectiv)
GBL_MISSING(glGetQueryObjectui64v)
GBL_MISSING(glMemoryBarrier)
GBL_MISSING(glMultiDrawElements)
GBL_MISSING(glObjectLabel)
GBL_MISSING(glPatchParameteri)
GBL_MISSING(glPolygonMode)
GBL_MISSING(glPopDebugGroup)
GBL_MISSING(glPushDebugGroup)
GBL_MISSING(glTexBuffer)
#undef GBL_MISSING
#define glFinish gbl::web::finish
inline void glClipControl(GLenum origin, GLenum depth) { gbl::web::clip_control(origin, depth); }
