#include "renderer/gl/gl_error.h"

#include <fmt/format.h>
#include <span>

#include "renderer/base/error.h"
#include "renderer/gl/misuse.h"

namespace gbl::gl {
namespace {

struct Word {
  GLenum value;
  const char *name, *text;
};
#define GBL_WORD(name, text) \
  { name, #name, text }
constexpr Word kErrors[] = {
    GBL_WORD(GL_NO_ERROR, "the driver gives no reason"),
    GBL_WORD(GL_INVALID_ENUM, "a name that the driver does not know"),
    GBL_WORD(GL_INVALID_VALUE, "a number beyond the driver's limits"),
    GBL_WORD(GL_INVALID_OPERATION, "not possible in this state"),
    GBL_WORD(GL_INVALID_FRAMEBUFFER_OPERATION, "the framebuffer is not complete"),
    GBL_WORD(GL_OUT_OF_MEMORY, "out of memory"),
};
constexpr Word kStatuses[] = {
    GBL_WORD(GL_FRAMEBUFFER_UNDEFINED, "there is no window to draw into"),
    GBL_WORD(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "an attachment has no texels, or a format that is not drawn into"),
    GBL_WORD(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT, "nothing is attached"),
    GBL_WORD(GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER, "a draw buffer has no attachment"),
    GBL_WORD(GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER, "the read buffer has no attachment"),
    GBL_WORD(GL_FRAMEBUFFER_UNSUPPORTED, "the driver does not draw into these formats together"),
    GBL_WORD(GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE, "the attachments differ in samples per pixel"),
    GBL_WORD(GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS, "some attachments have layers and some have none"),
};
#undef GBL_WORD

std::string in_words(std::span<const Word> words, GLenum value) {
  for (const Word& w : words)
    if (w.value == value) return fmt::format("{} ({})", w.text, w.name);
  return fmt::format("0x{:x}", value);
}

// GL may hold one error of each kind; a lost context answers without end.
void report_older_errors(std::string_view where) {
  for (size_t i = 0; i < std::size(kErrors); ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    report_misuse(fmt::format("nobody asked for an error from before '{}': {}", where, error_text(error)));
  }
}

}  // namespace

std::string error_text(GLenum error) { return in_words(kErrors, error); }
std::string framebuffer_text(GLenum status) { return in_words(kStatuses, status); }

void attempt(const Attempt& a, const std::function<void()>& call) {
  report_older_errors(a.where);
  call();
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
    throw Error(ExitCode::unfinished, a.where, fmt::format("{} failed: {}", a.what, error_text(error)), a.advice);
}

}  // namespace gbl::gl
