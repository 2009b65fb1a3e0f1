#include "renderer/gl/readback.h"

#include <cstring>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gl/gl_error.h"

namespace gbl::gl {
namespace {

// A framebuffer for this one read.
class ReadScope {
 public:
  explicit ReadScope(const Texture& t) : fbo_(make_framebuffer({.colours = {&t}, .label = "read-back"})) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, fbo_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    state_pixel_storage();
  }
  ~ReadScope() { glBindFramebuffer(GL_READ_FRAMEBUFFER, 0); }

 private:
  Framebuffer fbo_;
};

}  // namespace

namespace {

constexpr const char* kReadAgain = "read it again; if it stays so, choose a smaller size";

template <class Value>
std::vector<Value> read_now(const Texture& t, GLenum type) {
  const ReadScope scope(t);
  std::vector<Value> pixels(4u * t.size.x * t.size.y);
  attempt({t.label, "the read-back", kReadAgain},
          [&] { glReadPixels(0, 0, t.size.x, t.size.y, GL_RGBA, type, pixels.data()); });
  return pixels;
}

// The state of glClientWaitSync; with `wait` never "not yet", however slow the frame.
GLenum state_of(GLsync fence, bool wait) {
  constexpr GLuint64 kOneSecondNs = 1'000'000'000;
  GLenum state = GL_TIMEOUT_EXPIRED;
  do state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? kOneSecondNs : 0);
  while (wait && state == GL_TIMEOUT_EXPIRED);
  return state;
}

}  // namespace

std::vector<uint8_t> read_rgba8(const Texture& t) { return read_now<uint8_t>(t, GL_UNSIGNED_BYTE); }
std::vector<float> read_rgba32f(const Texture& t) { return read_now<float>(t, GL_FLOAT); }

AsyncRead::~AsyncRead() { drop(); }

void AsyncRead::drop() {
  if (fence_) glDeleteSync(fence_);
  fence_ = nullptr;
}

void AsyncRead::start(const Texture& t) {
  if (!buffer_) buffer_ = Buffer::make();
  drop();
  label_ = t.label;
  data_.resize(4u * t.size.x * t.size.y);
  const ReadScope scope(t);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(data_.size() * sizeof(float)), nullptr, GL_STREAM_READ);
  glReadPixels(0, 0, t.size.x, t.size.y, GL_RGBA, GL_FLOAT, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

const std::vector<float>* AsyncRead::take(bool wait) {
  if (!fence_) return nullptr;
  const GLenum state = state_of(fence_, wait);
  if (state == GL_TIMEOUT_EXPIRED) return nullptr;
  drop();
  if (state == GL_WAIT_FAILED) fail("waiting for the read-back");
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  const size_t bytes = data_.size() * sizeof(float);
  const void* mapped = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
  if (mapped) std::memcpy(data_.data(), mapped, bytes);
  const bool whole = mapped && glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  if (!whole) fail("mapping the read-back");
  return &data_;
}

void AsyncRead::fail(const char* what) const {
  throw Error(ExitCode::unfinished, label_, fmt::format("{} failed: {}", what, error_text(glGetError())), kReadAgain);
}

}  // namespace gbl::gl
