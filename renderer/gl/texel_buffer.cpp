#include "renderer/gl/texel_buffer.h"

#include <array>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gl/device.h"
#include "renderer/gl/gl_error.h"
#include "renderer/gl/texture_units.h"

namespace gbl::gl {

void write_texels(TexelBuffer& table, Format format, const void* texels, size_t count, std::string_view label) {
  constexpr std::array<char, 16> kZeros{};
  if (count == 0) texels = kZeros.data(), count = 1;
  const size_t bytes = count * static_cast<size_t>(row(format).bytes);
  if (count > device().max_buffer_texels)
    throw Error(
        ExitCode::no_gl, label,
        fmt::format("{} texels are needed, and a buffer of this driver holds {}", count, device().max_buffer_texels),
        "choose fewer lights or a scene of fewer objects");
  const bool is_new = !table.name;
  if (is_new) table.name = Object<Kind::texture>::make(), table.texels = Buffer::make();
  glBindBuffer(GL_TEXTURE_BUFFER, table.texels.id());
  attempt({label, fmt::format("a buffer of {} bytes", bytes), "choose fewer lights or a scene of fewer objects"},
          [&] { glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), texels, GL_STREAM_DRAW); });
  if (!is_new) return;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, table.name.id());
  glTexBuffer(GL_TEXTURE_BUFFER, gl_format(format).internal, table.texels.id());
  set_label(GL_TEXTURE, table.name.id(), label);
}

void bind_texels(std::string_view sampler, const TexelBuffer& table) {
  activate_unit_of(sampler);
  glBindTexture(GL_TEXTURE_BUFFER, table.name.id());
}

}  // namespace gbl::gl
