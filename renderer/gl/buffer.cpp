#include "renderer/gl/buffer.h"

#include <fmt/format.h>

#include "renderer/gl/device.h"
#include "renderer/gl/gl_error.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {

Buffer make_buffer(GLenum target, const void* data, size_t bytes, std::string_view label) {
  Buffer b = Buffer::make();
  glBindVertexArray(0);  // an element buffer would otherwise be caught by the bound vertex array
  glBindBuffer(target, b.id());
  attempt({label, fmt::format("a buffer of {} bytes", bytes), "choose a scene of fewer triangles"},
          [&] { glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW); });
  set_label(GL_BUFFER, b.id(), label);
  glBindBuffer(target, 0);
  return b;
}

VertexArray make_vertex_array(const Buffer& vertices, size_t stride, std::span<const VertexAttribute> attributes,
                              const Buffer* indices) {
  VertexArray v = VertexArray::make();
  glBindVertexArray(v.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
  for (const VertexAttribute& a : attributes) {
    glEnableVertexAttribArray(a.location);
    glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(a.offset));
  }
  if (indices) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices->id());
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return v;
}

void draw_runs(std::span<const GLsizei> counts, std::span<const void* const> offsets) {
  const auto runs = static_cast<GLsizei>(counts.size());
  if (device().api == Api::core)
    return glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(), runs);
  for (size_t i = 0; i < counts.size(); ++i) glDrawElements(GL_TRIANGLES, counts[i], GL_UNSIGNED_INT, offsets[i]);
}

VertexArray make_empty_vertex_array() { return VertexArray::make(); }

void write_uniform_block(const Buffer& b, GLuint binding, const void* data, size_t bytes) {
  glBindBuffer(GL_UNIFORM_BUFFER, b.id());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, b.id());
}

}  // namespace gbl::gl
