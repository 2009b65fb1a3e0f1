#pragma once
// Tables that shaders read by index (table_at() in program.cpp): texels in a buffer, without rows, levels or the size limit of
// a uniform block. On a CPU rasteriser such a fetch takes about half the time of one from a 2D texture, which is what GLES 3.0
// has instead, in rows of kTableWidth.
#include <cstddef>
#include <string_view>
#include <utility>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {

struct Device;

inline constexpr int kTableWidth = 2048;  // texels: every GLES 3.0 has as many

struct TexelBuffer {
  Object<Kind::texture> name;
  Buffer texels;                  // none in GLES
  std::pair<Format, int> room{};  // of GLES: a texture of so many rows is there
};

// Written anew as a whole; Error if the driver's tables hold fewer texels or it has no room. A table of none has one of
// zeros.
void write_texels(TexelBuffer&, Format, const void* texels, size_t count, std::string_view label);

void bind_texels(std::string_view sampler, const TexelBuffer&);

size_t max_table_texels(const Device&);  // of a current context

}  // namespace gbl::gl
