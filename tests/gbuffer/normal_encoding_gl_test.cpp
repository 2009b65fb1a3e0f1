// The GPU's normals are the CPU's: the same directions through pack, store and unpack of the shaders' own text, for every
// encoding, against the same text compiled by C++.
#include "renderer/gbuffer/normal_encoding.h"

#include <optional>

#include "renderer/passes/frame_block.h"
#include "renderer/passes/normal_texels.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class NormalEncodings : public GlTest {};

constexpr int kSide = 1024;  // 2^20 directions

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

using Result = NormalTexels;

Result through_the_gpu(Settings s, NormalEncoding encoding) {
  s.normal.encoding = encoding;
  return normals_through_gpu(s, directions(), s.size);
}

Settings square() { return settings_for(yard(), {kSide, kSide}); }

bool finite(const glm::vec4& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// How this device stores halves; no value if neither to nearest nor toward zero.
std::optional<StoreRounding> rounding_here() {
  const gl::Rounding found = gl::probe_rounding().half_store;
  if (found == gl::Rounding::other) return {};
  return found == gl::Rounding::to_nearest ? StoreRounding::to_nearest : StoreRounding::toward_zero;
}

TEST_F(NormalEncodings, GpuCodesAndNormalsAreTheCpus) {
  const std::optional<StoreRounding> rounding = rounding_here();
  const std::vector<glm::vec4> input = directions();
  for_each_row<NormalEncoding>([&](NormalEncoding e, auto& r) {
    SCOPED_TRACE(r.id);
    if (!row_of(e).whole_codes() && !rounding) return;
    const Result gpu = through_the_gpu(square(), e);
    int codes_off = 0, without_normal = 0;
    double worst_deg = 0;
    for (size_t i = 0; i < input.size(); ++i) {
      const StoreRounding store = rounding.value_or(StoreRounding::to_nearest);
      const glm::vec3 n = input[i], code = stored_code(e, n, store), normal = stored_normal(e, n, store);
      const bool has_normal = finite(glm::vec4(normal, 0));
      EXPECT_EQ(finite(gpu.decoded[i]), has_normal) << i;
      if (!has_normal) {
        ++without_normal;
        EXPECT_TRUE(row_of(e).lost && row_of(e).lost(n)) << "only the pitfall has no normal";
        continue;
      }
      for (int k = 0; k < row_of(e).channels; ++k) codes_off += gpu.codes[i][k] != code[k];
      worst_deg = std::max(worst_deg, angle_deg(glm::dvec3(gpu.decoded[i]), glm::dvec3(normal)));
    }
    EXPECT_EQ(codes_off, 0);
    EXPECT_LT(worst_deg, 2e-5) << "float arithmetic of the decoding; an inverse square root may be off by some ulp";
    EXPECT_EQ(without_normal > 0, e == NormalEncoding::stereo16f) << "the directions hold its pole -Z";
    EXPECT_LT(without_normal, 100);
  });
}

// normal.space=view: what comes back is along the world's axes again, as good as the encoding is.
TEST_F(NormalEncodings, ViewSpaceTurnsThereAndBack) {
  Settings s = square();
  s.normal.space = NormalSpace::view;
  const glm::dmat4 view_from_world = glm::mat4_cast(glm::conjugate(orientation_from_yaw_pitch(37, -22)));
  shared::FrameBlock block{};
  block.view_from_world = glm::mat4(view_from_world);
  const gl::Buffer buffer = gl::Buffer::make();
  gl::write_uniform_block(buffer, 0, &block, sizeof block);
  const std::vector<glm::vec4> input = directions();
  for_each_row<NormalEncoding>([&](NormalEncoding e, auto& r) {
    SCOPED_TRACE(r.id);
    const Result gpu = through_the_gpu(s, e);
    const Degrees& column = row_of(e).toward_zero.value_or(row_of(e).error);
    double worst_deg = 0, codes_off = 0;
    for (size_t i = 0; i < input.size(); ++i) {
      const glm::dvec3 n(input[i]), turned = view_from_world * glm::dvec4(n, 0);
      if (row_of(e).lost && row_of(e).lost(turned)) continue;
      worst_deg = std::max(worst_deg, angle_deg(n, glm::dvec3(gpu.decoded[i])));
      codes_off += glm::dvec3(gpu.codes[i]) != stored_code(e, turned);
    }
    // Two rotations in float beside it: 4e-7 radians.
    EXPECT_LE(worst_deg, 1.005 * column.max + 5e-5);
    const double few = row_of(e).whole_codes() ? 0.1 * kSide * kSide : kSide * kSide;
    EXPECT_LE(codes_off, few) << "the codes are those of the turned direction, but for float's digits";
  });
}

}  // namespace
}  // namespace gbl::test
