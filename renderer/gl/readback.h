#pragma once
// Pixels from textures to the CPU: at once for files, or some frames later without waiting for the window.
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {

// Rows bottom to top, as GL has them. These wait for the GPU.
std::vector<uint8_t> read_rgba8(const Texture&);
std::vector<float> read_rgba32f(const Texture&);
std::vector<float> read_depth(const Texture&);  // window depth, one a texel

// A read-back under way: start() never waits, take() gives the data once it has arrived.
class AsyncBytes {
 public:
  AsyncBytes();  // makes its buffer, without storage, so that use makes no name of OpenGL
  ~AsyncBytes();
  AsyncBytes(const AsyncBytes&) = delete;
  // `read` calls glReadPixels with offsets into the bound buffer. Replaces what is under way.
  void start(std::string label, size_t bytes, const std::function<void()>& read);
  void drop();  // forgets what is under way
  bool pending() const { return fence_ != nullptr; }
  // Null until it has arrived (never with `wait`, if one is under way); the data is valid until the next start().
  // Error if the driver fails.
  const std::vector<std::byte>* take(bool wait = false);

 private:
  [[noreturn]] void fail(const char* what) const;
  Buffer buffer_;
  std::string label_;
  GLsync fence_ = nullptr;
  std::vector<std::byte> data_;
};

// A whole texture of floats.
class AsyncRead {
 public:
  void start(const Texture& rgba32f);
  void drop() { bytes_.drop(); }
  bool pending() const { return bytes_.pending(); }
  const std::vector<float>* take(bool wait = false);  // four a texel; as above

 private:
  AsyncBytes bytes_;
  std::vector<float> values_;
};

// The same texel of many textures, bit by bit.
class AsyncTexels {
 public:
  void start(std::span<const Texture* const>, glm::ivec2 texel);
  void drop() { bytes_.drop(); }
  // Of each texture its channels' bits as FormatRow says, the lowest first in each word; a stencil is the second.
  std::optional<std::vector<std::array<uint32_t, 4>>> take(bool wait = false);

 private:
  AsyncBytes bytes_;
  std::vector<Format> formats_;
};

}  // namespace gbl::gl
