#pragma once
// Vertex, index and uniform buffers, and the vertex arrays that read them.
#include <cstddef>
#include <initializer_list>
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
};
VertexArray make_vertex_array(const Buffer& vertices, size_t stride, std::initializer_list<VertexAttribute>,
                              const Buffer* indices);
VertexArray make_empty_vertex_array();  // for shaders that only read gl_VertexID

// One uniform block, rewritten once a frame.
void write_uniform_block(const Buffer&, GLuint binding, const void* data, size_t bytes);

}  // namespace gbl::gl
