// The GPU's normals are the CPU's: the same directions through pack, store and unpack of the shaders' own text, for every
// encoding, against the same text compiled by C++.
#include "renderer/normal_encoding.h"

#include <glm/gtc/packing.hpp>
#include <optional>

#include "renderer/gl/pass_state.h"
#include "renderer/passes/programs.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace cpu {  // as renderer/normal_encoding.cpp includes it; here the codes themselves are wanted
using real = float;
using glm::abs, glm::clamp, glm::floor, glm::normalize, glm::vec2, glm::vec3;
#include "shaders/normal_encoding.glsl"
}  // namespace cpu

namespace {

class NormalEncodings : public GlTest {};

constexpr int kSide = 128;  // 128 x 128 directions

// Evenly over the sphere, then the axes, the octahedron's seams and folds, and a ring about the pole -Z.
std::vector<glm::vec4> directions() {
  std::vector<glm::dvec3> out;
  for (const double sign : {-1.0, 1.0})
    for (int k = 0; k < 3; ++k) {
      glm::dvec3 axis(0), diagonal(sign);
      axis[k] = sign;
      diagonal[k] = 0;
      out.insert(out.end(), {axis, diagonal, glm::dvec3(sign, k - 1, sign * (1 - k)), glm::dvec3(k - 1, sign, -sign)});
    }
  for (int k = 0; k < 64; ++k) {
    const double turn = 2 * 3.14159265358979 * k / 64, tilt = 1e-5 * (k + 1);
    out.push_back({tilt * std::cos(turn), tilt * std::sin(turn), -1});
    out.push_back({std::cos(turn), std::sin(turn), 0});  // the equator, where the octahedron folds
  }
  for (int i = 0; out.size() < kSide * kSide; ++i) {
    const double z = 1 - 2 * (i + 0.5) / (kSide * kSide), turn = 2.39996322972865 * i;  // golden angle
    out.push_back({std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z});
  }
  std::vector<glm::vec4> rounded;
  for (const glm::dvec3& d : out) rounded.emplace_back(glm::vec3(glm::normalize(d)), 0);
  return rounded;
}

// Runs a fragment shader of the given main() over all directions; `included` supplies the functions it calls.
void run(const Settings& s, const char* uniform, const char* main, const gl::Texture& from, const gl::Texture& to) {
  const gl::Defines defines = gbuffer_defines(s);
  gl::ShaderText fragment = gl::load_shader("surface.glsl", defines);
  fragment.body += std::string(uniform) + "void main() {\n  ivec2 texel = ivec2(gl_FragCoord.xy);\n" + main + "}\n";
  const gl::Program program = gl::compile_program(gl::load_shader("fullscreen.vert", defines), fragment);
  const gl::Framebuffer target = gl::make_framebuffer({.colours = {&to}, .label = "normals"});
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glViewport(0, 0, kSide, kSide);
  gl::apply({});
  gl::bind_texture(0, from);
  glUseProgram(program.id());
  glUniform1i(program.uniform("source"), 0);
  Shapes().draw_fullscreen();
}

struct Result {
  std::vector<glm::vec4> codes, decoded;
};

Result through_the_gpu(NormalEncoding encoding) {
  Settings s = settings_for(yard(), {kSide, kSide});
  s.normal.encoding = encoding;
  const std::vector<glm::vec4> input = directions();
  const gl::Texture source = gl::make_texture({.size = s.size, .format = Format::rgba32f, .label = "directions"});
  gl::bind_texture(0, source);
  gl::state_pixel_storage();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, input.data());
  const std::vector<Attachment> all = attachments(s);
  const gl::Texture stored = gl::make_texture({.size = s.size, .format = find(all, Stores::normal)->format});
  const gl::Texture codes = gl::make_texture({.size = s.size, .format = Format::rgba32f});
  const gl::Texture decoded = gl::make_texture({.size = s.size, .format = Format::rgba32f});
  run(s, "uniform sampler2D source;\nlayout(location = 0) out NORMAL_OUTPUT result;\n",
      "  result = pack_normal(texelFetch(source, texel, 0).xyz);\n", source, stored);
  const char* reads = "uniform NORMAL_SAMPLER source;\nlayout(location = 0) out vec4 result;\n";
  run(s, reads, "  result = vec4(texelFetch(source, texel, 0));\n", stored, codes);
  run(s, reads, "  result = vec4(unpack_normal(texelFetch(source, texel, 0)), 0.0);\n", stored, decoded);
  return {picture_of(codes).texels, picture_of(decoded).texels};
}

// The integer code that the CPU computes, or no value for a float format.
std::optional<glm::vec3> cpu_code(NormalEncoding e, const glm::vec3& n) {
  switch (e) {
    case NormalEncoding::oct16: return cpu::encode_oct16(n);
    case NormalEncoding::oct8: return cpu::encode_oct8(n);
    case NormalEncoding::xyz8: return cpu::encode_xyz8(n);
    default: return {};
  }
}

TEST_F(NormalEncodings, GpuCodesAndNormalsAreTheCpus) {
  const std::vector<glm::vec4> input = directions();
  for_each_row<NormalEncoding>([&](NormalEncoding e, auto& r) {
    SCOPED_TRACE(r.id);
    if (!cpu_code(e, {0, 0, 1})) return;
    const Result gpu = through_the_gpu(e);
    int codes_off = 0;
    double worst_deg = 0;
    for (size_t i = 0; i < input.size(); ++i) {
      const glm::vec3 n = input[i];
      const glm::vec3 code = *cpu_code(e, n);
      const float levels = e == NormalEncoding::oct16 ? 1 : 255;  // the others are stored as unorm of 8 bits
      codes_off += glm::round(glm::vec3(gpu.codes[i]) * levels) != code;
      const double off = angle_deg(glm::dvec3(gpu.decoded[i]), glm::dvec3(stored_normal_f32(e, n)));
      worst_deg = std::max(worst_deg, off);
    }
    EXPECT_EQ(codes_off, 0);
    EXPECT_LT(worst_deg, 2e-5) << "float arithmetic of the decoding; an inverse square root may be off by some ulp";
  });
}

// The half that a store of `x` gives, rounded as the device was found to round.
float stored_half(float x, gl::Rounding rounding) {
  const float nearest = glm::unpackHalf1x16(glm::packHalf1x16(x));
  if (rounding == gl::Rounding::to_nearest || std::abs(nearest) <= std::abs(x)) return nearest;
  return glm::unpackHalf1x16(static_cast<uint16_t>(glm::packHalf1x16(x) - 1));  // one step towards zero
}

TEST_F(NormalEncodings, StereographicHalvesAreTheCpusAsThisDeviceRounds) {
  const gl::Rounding rounding = gl::probe_rounding().half_store;
  if (rounding == gl::Rounding::other) GTEST_SKIP() << "this device rounds neither to nearest nor toward zero";
  const std::vector<glm::vec4> input = directions();
  const Result gpu = through_the_gpu(NormalEncoding::stereo16f);
  int without_code = 0;
  for (size_t i = 0; i < input.size(); ++i) {
    const glm::vec3 n = input[i], exact = cpu::encode_stereo16f(n);
    if (!std::isfinite(exact.x + exact.y)) {  // the pitfall: no code, and no normal comes back
      ++without_code;
      EXPECT_FALSE(std::isfinite(gpu.decoded[i].x + gpu.decoded[i].y + gpu.decoded[i].z)) << i;
      continue;
    }
    for (int k = 0; k < 2; ++k) EXPECT_EQ(gpu.codes[i][k], stored_half(exact[k], rounding)) << i << ": " << exact[k];
    // Two neighbouring halves are at most .06 degrees apart: twice the largest error that the catalogue measured.
    EXPECT_LT(angle_deg(glm::dvec3(gpu.decoded[i]), glm::dvec3(stored_normal_f32(NormalEncoding::stereo16f, n))), 0.06);
  }
  EXPECT_GT(without_code, 0) << "the directions hold the pole -Z";
  EXPECT_LT(without_code, 100);
}

// Every encoding of the table is compared by one of the two tests above.
TEST_F(NormalEncodings, NoneIsLeftOut) {
  for_each_row<NormalEncoding>([](NormalEncoding e, auto& r) {
    EXPECT_TRUE(cpu_code(e, {0, 0, 1}) || e == NormalEncoding::stereo16f) << r.id << " is compared by no test";
  });
}

}  // namespace
}  // namespace gbl::test
