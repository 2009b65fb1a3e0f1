#pragma once
// How texels of each format come to memory. OpenGL reads all that is stored; GLES reads fewer kinds of client data, and no
// depth: a pass writes depths as floats first.
#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/gl/texture.h"

namespace gbl::gl {

bool reads_depth();  // false: as a shader samples it, and no stencil

inline constexpr size_t kMostTexelBytes = 16;  // of client data

// What glReadPixels is told, so that nothing of a texel is lost.
struct Transfer {
  GLenum channels, type;
};
Transfer transfer_of(Format);

// The channels' bits as FormatRow says, of one texel of such client data. A stencil is the second, if it is read.
std::array<uint32_t, 4> stored_bits(const std::byte* texel, Format);

// The texture itself, or its depths in R32F.
class Readable {
 public:
  explicit Readable(const Texture&);
  const Texture& operator*() const { return depths_.name ? depths_ : of_; }

 private:
  const Texture& of_;
  Texture depths_;
};

}  // namespace gbl::gl
