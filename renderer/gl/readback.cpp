#include "renderer/gl/readback.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gl/device.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/gl_error.h"
#include "renderer/gl/transfer.h"

namespace gbl::gl {
namespace {

// A framebuffer for this one read.
class ReadScope {
 public:
  explicit ReadScope(const Texture& t) : fbo_(make_framebuffer(of(t))) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, fbo_.id());
    glReadBuffer(is_depth(t) ? GL_NONE : GL_COLOR_ATTACHMENT0);
    if (device().api == Api::core) glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  }
  ~ReadScope() { glBindFramebuffer(GL_READ_FRAMEBUFFER, 0); }

 private:
  static bool is_depth(const Texture& t) { return row(t.format).numeric == Numeric::depth; }
  static FramebufferDesc of(const Texture& t) {
    if (is_depth(t)) return {.depth = &t, .label = "read-back"};
    return {.colours = {&t}, .label = "read-back"};
  }
  Framebuffer fbo_;
};

constexpr const char* kReadAgain = "read it again; if it stays so, choose a smaller size";

template <class Value>
std::vector<Value> read_now(const Texture& t, GLenum channels, GLenum type) {
  const ReadScope scope(t);
  state_pixel_storage();
  const size_t values_per_texel = channels == GL_RGBA ? 4 : 1;
  std::vector<Value> pixels(values_per_texel * t.size.x * t.size.y);
  attempt({t.label, "the read-back", kReadAgain},
          [&] { glReadPixels(0, 0, t.size.x, t.size.y, channels, type, pixels.data()); });
  return pixels;
}

}  // namespace

std::vector<uint8_t> read_rgba8(const Texture& t) { return read_now<uint8_t>(t, GL_RGBA, GL_UNSIGNED_BYTE); }

std::vector<float> read_rgba32f(const Texture& t) {
  if (transfer_of(t.format).type != GL_UNSIGNED_BYTE || device().api == Api::core)
    return read_now<float>(t, GL_RGBA, GL_FLOAT);
  const std::vector<uint8_t> codes = read_rgba8(t);
  std::vector<float> out(codes.size());
  std::transform(codes.begin(), codes.end(), out.begin(), [](uint8_t code) { return float(code) / 255; });
  return out;
}

std::vector<float> read_depth(const Texture& t) {
  if (device().api == Api::core) return read_now<float>(t, GL_DEPTH_COMPONENT, GL_FLOAT);
  const std::vector<float> in_red = read_now<float>(*Readable(t), GL_RGBA, GL_FLOAT);
  std::vector<float> out(in_red.size() / 4);
  for (size_t i = 0; i < out.size(); ++i) out[i] = in_red[4 * i];
  return out;
}

AsyncBytes::AsyncBytes() : buffer_(Buffer::make()) {
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());  // a name becomes a buffer, which can be labelled, when it is bound
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  set_label(GL_BUFFER, buffer_.id(), "read-back");
}

AsyncBytes::~AsyncBytes() { drop(); }

void AsyncBytes::drop() {
  if (fence_) glDeleteSync(fence_);
  fence_ = nullptr;
}

void AsyncBytes::start(std::string label, size_t bytes, const std::function<void()>& read) {
  drop();
  label_ = std::move(label);
  state_pixel_storage();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  if (data_.size() != bytes)
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_READ);
  data_.resize(bytes);
  read();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

const std::vector<std::byte>* AsyncBytes::take(bool wait) {
  if (!fence_) return nullptr;
  const GLenum state = state_of(fence_, wait);
  if (state == GL_TIMEOUT_EXPIRED) return nullptr;
  drop();
  if (state == GL_WAIT_FAILED) fail("waiting for the read-back");
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  const bool whole = read_bound_buffer(GL_PIXEL_PACK_BUFFER, data_.data(), data_.size());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  if (!whole) fail("mapping the read-back");
  return &data_;
}

void AsyncBytes::fail(const char* what) const {
  throw Error(ExitCode::unfinished, label_, fmt::format("{} failed: {}", what, error_text(glGetError())), kReadAgain);
}

void AsyncRead::start(const Texture& t) {
  values_.resize(4u * t.size.x * t.size.y);
  const ReadScope scope(t);
  bytes_.start(t.label, values_.size() * sizeof(float),
               [&] { glReadPixels(0, 0, t.size.x, t.size.y, GL_RGBA, GL_FLOAT, nullptr); });
}

const std::vector<float>* AsyncRead::take(bool wait) {
  const std::vector<std::byte>* bytes = bytes_.take(wait);
  if (!bytes) return nullptr;
  std::memcpy(values_.data(), bytes->data(), bytes->size());
  return &values_;
}

void AsyncTexels::start(std::span<const Texture* const> textures, glm::ivec2 texel) {
  formats_.clear();
  for (const Texture* t : textures) formats_.push_back(t->format);
  std::vector<Readable> readable;
  for (const Texture* t : textures) readable.emplace_back(*t);
  bytes_.start("texels", kMostTexelBytes * textures.size(), [&] {
    for (size_t i = 0; i < textures.size(); ++i) {
      const ReadScope scope(*readable[i]);
      const Transfer t = transfer_of(textures[i]->format);
      glReadPixels(texel.x, texel.y, 1, 1, t.channels, t.type, reinterpret_cast<void*>(i * kMostTexelBytes));
    }
  });
}

std::optional<std::vector<std::array<uint32_t, 4>>> AsyncTexels::take(bool wait) {
  const std::vector<std::byte>* bytes = bytes_.take(wait);
  if (!bytes) return {};
  std::vector<std::array<uint32_t, 4>> out;
  for (size_t i = 0; i < formats_.size(); ++i)
    out.push_back(stored_bits(bytes->data() + i * kMostTexelBytes, formats_[i]));
  return out;
}

}  // namespace gbl::gl
