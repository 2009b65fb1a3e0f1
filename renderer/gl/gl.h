#pragma once
// The functions of OpenGL: loaded by libepoxy, or a browser's. And what this context says of itself.
#ifdef __EMSCRIPTEN__
#include "web/gl.h"
#else
#include <epoxy/gl.h>
#endif

#include <cstddef>

namespace gbl::gl {

bool is_desktop_gl();  // else OpenGL ES
int gl_version();      // 33: 3.3; as epoxy counts
bool has_extension(const char* name);
GLenum renderer_query();  // of glGetString: the device's own name, which browsers keep behind an extension
// Of glClientWaitSync; with `wait` never "not yet", however slow the frame.
GLenum state_of(GLsync fence, bool wait);
// The first bytes of the buffer that is bound there; false: the driver fails.
bool read_bound_buffer(GLenum target, void* to, size_t bytes);

}  // namespace gbl::gl
