#include "renderer/gl/transfer.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "renderer/gl/buffer.h"
#include "renderer/gl/device.h"
#include "renderer/gl/pass_state.h"
#include "renderer/gl/program.h"
#include "renderer/gl/texture_units.h"

namespace gbl::gl {
namespace {

bool es() { return device().api == Api::es3; }

constexpr const char* kCopiedDepth =
    "uniform sampler2D copied_depth;\nout vec4 depth;\n"
    "void main() { depth = vec4(texelFetch(copied_depth, ivec2(gl_FragCoord.xy), 0).r); }\n";

Texture depths_of(const Texture& t) {
  const Program program = compile_program(load_shader("fullscreen.vert", {}), {"depths.frag", kCopiedDepth});
  Texture depths = make_texture({.size = t.size, .format = Format::r32f, .label = t.label});
  const Framebuffer fbo = make_framebuffer({.colours = {&depths}, .label = t.label});
  const VertexArray none = make_empty_vertex_array();
  glBindFramebuffer(GL_FRAMEBUFFER, fbo.id());
  glViewport(0, 0, t.size.x, t.size.y);
  apply({});
  bind_texture("copied_depth", t);
  glUseProgram(program.id());
  glBindVertexArray(none.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return depths;
}

// Channel c of a texel as its client data holds it.
template <class Value>
Value channel(const std::byte* texel, size_t c) {
  Value v;
  std::memcpy(&v, texel + c * sizeof v, sizeof v);
  return v;
}

// What was stored in these bits, read as a float, gives these bits again: the float is representable in them.
uint32_t bits_of_float(float value, int bits) {
  if (bits == 32) return glm::floatBitsToUint(value);
  // 11 and 10 bits are a half float's without the sign, its fraction cut short. (GLM's own packing loses subnormal numbers.)
  return uint32_t{glm::packHalf1x16(value)} >> (bits == 16 ? 0 : 15 - bits);
}

uint32_t bits_of_depth(const std::byte* texel, Format format) {
  const int bits = row(format).channel_bits[0];
  if (!es()) return channel<uint32_t>(texel, 0) >> (32 - bits);  // fixed point fills the word from its top
  const auto depth = channel<float>(texel, 0);
  if (bits == 32) return glm::floatBitsToUint(depth);
  return static_cast<uint32_t>(std::llround(double(depth) * double((1u << bits) - 1)));
}

uint32_t bits_of_channel(const std::byte* texel, size_t c, Format format) {
  const FormatRow& f = row(format);
  if (f.numeric == Numeric::depth) return bits_of_depth(texel, format);
  switch (transfer_of(format).type) {
    case GL_FLOAT: return bits_of_float(channel<float>(texel, c), f.channel_bits[c]);
    case GL_UNSIGNED_BYTE: return channel<uint8_t>(texel, c);
    case GL_UNSIGNED_SHORT: return channel<uint16_t>(texel, c);
    default: return channel<uint32_t>(texel, c);
  }
}

}  // namespace

bool reads_depth() { return !es(); }

Transfer transfer_of(Format format) {
  if (!es()) return {gl_format(format).format, gl_format(format).type};
  switch (row(format).numeric) {
    case Numeric::unorm: return {GL_RGBA, GL_UNSIGNED_BYTE};
    case Numeric::uint: return {GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    default: return {GL_RGBA, GL_FLOAT};
  }
}

std::array<uint32_t, 4> stored_bits(const std::byte* texel, Format format) {
  std::array<uint32_t, 4> out{};
  for (size_t c = 0; c < static_cast<size_t>(row(format).channels); ++c) out[c] = bits_of_channel(texel, c, format);
  if (es()) return out;
  if (format == Format::d24s8) out[1] = channel<uint32_t>(texel, 0) & 0xff;
  if (format == Format::d32fs8) out[1] = channel<uint32_t>(texel, 1) & 0xff;
  return out;
}

Readable::Readable(const Texture& t) : of_(t) {
  if (es() && row(t.format).numeric == Numeric::depth) depths_ = depths_of(t);
}

}  // namespace gbl::gl
