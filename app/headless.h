#pragma once
// A GL context without a window or an X server: EGL, surfaceless platform. Current while it lives; then the one before is again.
#include <memory>

#include "renderer/gl/device.h"

namespace gbl {

class HeadlessContext {
 public:
  explicit HeadlessContext(gl::Api = gl::Api::core);  // Error(no_gl) with what is missing
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace gbl
