#pragma once
// Vertex, index and uniform buffers, and the vertex arrays that read them.
#include <cstddef>
#include <span>
#include <string_view>

#include "renderer/gl/object.h"

namespace gbl::gl {

using Buffer = Object<Kind::buffer>;
using VertexArray = Object<Kind::vertex_array>;

Buffer make_buffer(GLenum target, const void* data, size_t bytes, std::string_view label);  // Error without memory

struct VertexAttribute {
  GLuint location;
  GLint components;  // of float
  size_t offset;     // bytes
  constexpr size_t bytes() const { return static_cast<size_t>(components) * sizeof(float); }
};
VertexArray make_vertex_array(const Buffer& vertices, size_t stride, std::span<const VertexAttribute>,
                              const Buffer* indices);
// Several runs of one index buffer, bound with its vertex array: counts, and where each begins in bytes.
void draw_runs(std::span<const GLsizei> counts, std::span<const void* const> offsets);
VertexArray make_empty_vertex_array();  // for shaders that only read gl_VertexID

// One uniform block, rewritten once a frame.
void write_uniform_block(const Buffer&, GLuint binding, const void* data, size_t bytes);

}  // namespace gbl::gl
