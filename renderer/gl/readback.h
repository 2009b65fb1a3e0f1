#pragma once
// Pixels from textures to the CPU: at once for files, or some frames later without waiting for the window.
#include <string>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {

// Rows bottom to top, as GL has them. These wait for the GPU.
std::vector<uint8_t> read_rgba8(const Texture&);
std::vector<float> read_rgba32f(const Texture&);

// A read-back under way: start() never waits, take() gives the data once it has arrived.
class AsyncRead {
 public:
  AsyncRead() = default;
  ~AsyncRead();
  AsyncRead(const AsyncRead&) = delete;
  void start(const Texture& rgba32f);  // replaces one that is under way
  void drop();                         // forgets one that is under way
  bool pending() const { return fence_ != nullptr; }
  // Null until it has arrived (never with `wait`, if one is under way); the data is valid until the next start().
  // Error if the driver fails.
  const std::vector<float>* take(bool wait = false);

 private:
  [[noreturn]] void fail(const char* what) const;
  Buffer buffer_;
  std::string label_;
  GLsync fence_ = nullptr;
  std::vector<float> data_;
};

}  // namespace gbl::gl
