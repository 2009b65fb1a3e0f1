#include "renderer/gl/texel_buffer.h"

#include <array>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gl/device.h"
#include "renderer/gl/gl_error.h"
#include "renderer/gl/texture_units.h"

namespace gbl::gl {
namespace {

constexpr const char* kFewer = "choose fewer lights or a scene of fewer objects";

bool in_rows() { return device().api == Api::es3; }
GLenum target() { return in_rows() ? GL_TEXTURE_2D : GL_TEXTURE_BUFFER; }

void write_buffer(TexelBuffer& table, Format format, const void* texels, size_t bytes, std::string_view label) {
  const bool is_new = !table.texels;
  if (is_new) table.texels = Buffer::make();
  glBindBuffer(GL_TEXTURE_BUFFER, table.texels.id());
  attempt({label, fmt::format("a buffer of {} bytes", bytes), kFewer},
          [&] { glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), texels, GL_STREAM_DRAW); });
  if (is_new) glTexBuffer(GL_TEXTURE_BUFFER, gl_format(format).internal, table.texels.id());
}

// Whole rows, and what is left over in one more. Room is made only where there is none: a browser asked whether that went well
// waits for all that it was told before.
void write_rows(TexelBuffer& table, Format format, const void* texels, size_t count, std::string_view label) {
  const GlFormat f = gl_format(format);
  const auto whole = static_cast<GLsizei>(count / kTableWidth), rest = static_cast<GLsizei>(count % kTableWidth);
  const auto* bytes = static_cast<const std::byte*>(texels);
  state_pixel_storage();
  const std::pair<Format, int> needed(format, whole + (rest > 0));
  if (table.room != needed) {
    attempt({label, fmt::format("a table of {} texels", count), kFewer}, [&] {
      glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(f.internal), kTableWidth, needed.second, 0, f.format, f.type,
                   nullptr);
    });
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // there are no levels
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    table.room = needed;
  }
  if (whole > 0) glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTableWidth, whole, f.format, f.type, bytes);
  const size_t done = size_t(kTableWidth) * static_cast<size_t>(whole) * static_cast<size_t>(row(format).bytes);
  if (rest > 0) glTexSubImage2D(GL_TEXTURE_2D, 0, 0, whole, rest, 1, f.format, f.type, bytes + done);
}

}  // namespace

void write_texels(TexelBuffer& table, Format format, const void* texels, size_t count, std::string_view label) {
  constexpr std::array<char, 16> kZeros{};
  if (count == 0) texels = kZeros.data(), count = 1;
  if (count > device().max_table_texels)
    throw Error(
        ExitCode::no_gl, label,
        fmt::format("{} texels are needed, and a table of this driver holds {}", count, device().max_table_texels),
        kFewer);
  const bool is_new = !table.name;
  if (is_new) table.name = Object<Kind::texture>::make();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target(), table.name.id());
  if (in_rows())
    write_rows(table, format, texels, count, label);
  else
    write_buffer(table, format, texels, count * static_cast<size_t>(row(format).bytes), label);
  if (is_new) set_label(GL_TEXTURE, table.name.id(), label);
}

void bind_texels(std::string_view sampler, const TexelBuffer& table) {
  activate_unit_of(sampler);
  glBindTexture(target(), table.name.id());
}

size_t max_table_texels(const Device& d) {
  if (d.api == Api::es3) return size_t(kTableWidth) * static_cast<size_t>(d.max_size);
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  return static_cast<size_t>(texels);
}

}  // namespace gbl::gl
