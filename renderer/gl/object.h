#pragma once
// GL objects: move-only, typed, counted; 0 is "none". What is alive is counted, so that a test can see a leak.
#include <cstddef>
#include <utility>

#include "renderer/gl/gl.h"

namespace gbl::gl {

enum class Kind {
  texture,
  buffer,
  vertex_array,
  framebuffer,
  renderbuffer,
  program,
  query,
  vertex_shader,
  fragment_shader,
  compute_shader,
  control_shader,
  evaluation_shader,
  transform_feedback
};
inline constexpr size_t kKinds = static_cast<size_t>(Kind::transform_feedback) + 1;

GLuint create_name(Kind);
void delete_name(Kind, GLuint);
int live_names(Kind);
int live_names();  // over all kinds

template <Kind kKind>
class Object {
 public:
  Object() = default;
  explicit Object(GLuint id) : id_(id) {}
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Object() {
    if (id_) delete_name(kKind, id_);
  }
  static Object make() { return Object(create_name(kKind)); }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

}  // namespace gbl::gl
