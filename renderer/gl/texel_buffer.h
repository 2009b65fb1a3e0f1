#pragma once
// Tables that shaders read by index: texels in a buffer, without rows, levels or the size limit of a uniform block. On a
// CPU rasteriser such a fetch takes about half the time of one from a 2D texture.
#include <cstddef>
#include <string_view>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {

struct TexelBuffer {
  Object<Kind::texture> name;
  Buffer texels;
};

// Written anew as a whole; Error if the driver's buffers hold fewer texels or it has no room. A table of none has one of
// zeros.
void write_texels(TexelBuffer&, Format, const void* texels, size_t count, std::string_view label);

void bind_texels(std::string_view sampler, const TexelBuffer&);

}  // namespace gbl::gl
