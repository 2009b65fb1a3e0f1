#include "renderer/gl/readback.h"

#include <cstring>

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

std::vector<uint8_t> read_rgba8(const Texture& t) {
  const ReadScope scope(t);
  std::vector<uint8_t> pixels(4u * t.size.x * t.size.y);
  glReadPixels(0, 0, t.size.x, t.size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

std::vector<float> read_rgba32f(const Texture& t) {
  const ReadScope scope(t);
  std::vector<float> pixels(4u * t.size.x * t.size.y);
  glReadPixels(0, 0, t.size.x, t.size.y, GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

AsyncRead::~AsyncRead() { drop(); }

void AsyncRead::drop() {
  if (fence_) glDeleteSync(fence_);
  fence_ = nullptr;
}

void AsyncRead::start(const Texture& t) {
  if (!buffer_) buffer_ = Buffer::make();
  drop();
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
  constexpr GLuint64 kForever = 60'000'000'000;  // a minute, in ns
  const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? kForever : 0);
  if (state == GL_TIMEOUT_EXPIRED) return nullptr;
  glDeleteSync(fence_);
  fence_ = nullptr;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  const size_t bytes = data_.size() * sizeof(float);
  if (const void* mapped = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT)) {
    std::memcpy(data_.data(), mapped, bytes);
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  return &data_;
}

}  // namespace gbl::gl
