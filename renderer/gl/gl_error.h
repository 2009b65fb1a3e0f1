#pragma once
// GL's own errors, asked for where a call may fail for want of memory or by a limit, and said in words.
#include <functional>
#include <string>
#include <string_view>

#include "renderer/gl/gl.h"

namespace gbl::gl {

std::string error_text(GLenum error);         // "out of memory (GL_OUT_OF_MEMORY)"
std::string framebuffer_text(GLenum status);  // "nothing is attached (GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT)"

struct Attempt {
  std::string_view where;   // the object's label
  std::string_view what;    // "a texture of 64x64 RGBA8"
  std::string_view advice;  // what to do if it fails
};
// Error if `call` leaves an error of GL. One that was there before is not blamed on it: it is misuse (misuse.h).
void attempt(const Attempt&, const std::function<void()>& call);

}  // namespace gbl::gl
