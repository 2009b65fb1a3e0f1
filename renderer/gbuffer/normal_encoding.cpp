#include "renderer/gbuffer/normal_encoding.h"

#include <cmath>
#include <limits>

// The shader's text twice. GLM supplies GLSL's functions; `real` is the one word that differs.
using uint = unsigned;
namespace gbl::f32 {
namespace {
using real = float;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using glm::abs, glm::clamp, glm::floor, glm::max, glm::min, glm::normalize, glm::sqrt;
#include "shaders/normal_encoding.glsl"
}  // namespace
}  // namespace gbl::f32
namespace gbl::f64 {
namespace {
using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using glm::abs, glm::clamp, glm::floor, glm::max, glm::min, glm::normalize, glm::sqrt;
#include "shaders/normal_encoding.glsl"
}  // namespace
}  // namespace gbl::f64

namespace gbl {
namespace {

template <class V>
struct Codec {
  V (*encode)(V unit);
  V (*decode)(V code);
};
struct Encoding {
  EncodingRow row;
  Codec<glm::vec3> f32;
  Codec<glm::dvec3> f64;
};

// Where 1 + z has lost its digits in float: 0.1 degrees about -Z.
bool near_minus_z(const glm::dvec3& n) { return n.z < -1 + 1.6e-6; }
bool has_negative(const glm::dvec3& n) { return n.x < 0 || n.y < 0 || n.z < 0; }
bool points_down(const glm::dvec3& n) { return n.z < 0; }

// The row's fields, then the pair of shader functions of the same name, in both arithmetics.
#define ENCODING(name, ...)                                                        \
  {                                                                                \
    {NormalEncoding::name, __VA_ARGS__}, {f32::encode_##name, f32::decode_##name}, \
        {f64::encode_##name, f64::decode_##name},                                  \
  }
// clang-format off
// Format, channels, bits of each; degrees mean, 99th percentile, maximum, as tests/gbuffer/normal_encoding_test measures them.
constexpr Encoding kEncodings[] = {
  ENCODING(xyz8,          Format::rgba8,   3,  8, {0.170, 0.318, 0.389}),
  ENCODING(xyz8_raw,      Format::rgba8,   3,  8, {49.1, 157, 180}, {}, has_negative),
  ENCODING(xyz10,         Format::r32ui,   3, 10, {0.0423, 0.0791, 0.0971}),
  ENCODING(xyz16f,        Format::rgba16f, 3, 16, {0.00605, 0.0173, 0.0239}, Degrees{0.00635, 0.0187, 0.0280}),
  ENCODING(xyz32f,        Format::rgba32f, 3, 32, {6.06e-7, 1.83e-6, 2.92e-6}, Degrees{9.86e-7, 2.57e-6, 3.42e-6}),
  ENCODING(bestfit8,      Format::rgba8,   3,  8, {0.0305, 0.132, 0.319}),
  ENCODING(stereo16f,     Format::rg16f,   2, 16, {0.00833, 0.0212, 0.0280}, Degrees{0.0167, 0.0424, 0.0559}, near_minus_z),
  ENCODING(lambert16,     Format::rg16ui,  2, 16, {0.00195, 0.0101, 0.753}),
  ENCODING(spherical16,   Format::rg16ui,  2, 16, {0.00138, 0.00276, 0.00307}),
  ENCODING(oct8,          Format::rg8,     2,  8, {0.337, 0.758, 0.957}),
  ENCODING(oct10,         Format::r32ui,   2, 10, {0.0837, 0.188, 0.238}),
  ENCODING(oct12,         Format::r32ui,   2, 12, {0.0209, 0.0471, 0.0594}),
  ENCODING(oct14,         Format::r32ui,   2, 14, {0.00522, 0.0117, 0.0148}),
  ENCODING(oct16,         Format::rg16ui,  2, 16, {0.00131, 0.00293, 0.00371}),
  ENCODING(oct16_precise, Format::rg16ui,  2, 16, {0.00122, 0.00215, 0.00247}),
  ENCODING(xy_sqrt,       Format::r32ui,   2, 12, {32.7, 157, 180}, {}, points_down),
};
// clang-format on
#undef ENCODING

constexpr bool encodings_in_order() {
  for (size_t i = 0; i < std::size(kEncodings); ++i)
    if (kEncodings[i].row.encoding != static_cast<NormalEncoding>(i)) return false;
  return true;
}
static_assert(encodings_in_order());

const Encoding& encoding_of(NormalEncoding e) { return kEncodings[static_cast<size_t>(e)]; }
const Codec<glm::vec3>& codec_of(const Encoding& e, const glm::vec3&) { return e.f32; }
const Codec<glm::dvec3>& codec_of(const Encoding& e, const glm::dvec3&) { return e.f64; }

struct FloatFormat {
  int digits, min_exponent;  // as std::numeric_limits has them
  double largest;
};
constexpr FloatFormat kHalf = {11, -13, 65504};
using Float = std::numeric_limits<float>;
constexpr FloatFormat kFloat = {Float::digits, Float::min_exponent, Float::max()};

// The nearest float (ties to even), or the next toward zero.
double rounded(double x, const FloatFormat& f, StoreRounding rounding) {
  if (!std::isfinite(x)) return x;
  int exponent = 0;
  std::frexp(x, &exponent);
  const double step = std::ldexp(1.0, std::max(exponent, f.min_exponent) - f.digits);
  if (rounding == StoreRounding::toward_zero) return glm::clamp(std::trunc(x / step) * step, -f.largest, f.largest);
  const double nearest = std::nearbyint(x / step) * step;
  return std::abs(nearest) > f.largest ? std::copysign(INFINITY, x) : nearest;
}

// A texel's channel as a float format keeps it; the channels that the encoding does not use are not read.
template <class V>
V stored_floats(const EncodingRow& e, const V& code, StoreRounding rounding) {
  using Real = typename V::value_type;
  V out(0);
  for (int k = 0; k < e.channels; ++k)
    out[k] = static_cast<Real>(rounded(code[k], e.bits_per_channel == 16 ? kHalf : kFloat, rounding));
  return out;
}

glm::vec3 through_word(const glm::vec3& code, int bits) {
  return f32::code_from_word(f32::word_from_code(code, bits), bits);
}
glm::dvec3 through_word(const glm::dvec3& code, int bits) {
  return f64::code_from_word(f64::word_from_code(code, bits), bits);
}

template <class V>
V code_in_texel(const Encoding& e, const V& unit, StoreRounding rounding) {
  const V code = codec_of(e, unit).encode(unit);
  if (!e.row.whole_codes()) return stored_floats(e.row, code, rounding);
  return e.row.storage() == NormalStorage::word ? through_word(code, e.row.bits_per_channel) : code;
}

template <class V>
V read_back(NormalEncoding encoding, const V& unit, StoreRounding rounding) {
  const Encoding& e = encoding_of(encoding);
  return codec_of(e, unit).decode(code_in_texel(e, unit, rounding));
}

}  // namespace

const EncodingRow& row_of(NormalEncoding e) { return encoding_of(e).row; }

NormalStorage EncodingRow::storage() const {
  const FormatRow& f = row(format);
  if (f.numeric == Numeric::floating) return NormalStorage::floats;
  if (f.numeric == Numeric::unorm) return NormalStorage::unorm8;
  return f.channels == 1 ? NormalStorage::word : NormalStorage::uints;
}

glm::dvec3 stored_code(NormalEncoding e, const glm::dvec3& n, StoreRounding r) {
  return code_in_texel(encoding_of(e), n, r);
}
glm::vec3 stored_code(NormalEncoding e, const glm::vec3& n, StoreRounding r) {
  return code_in_texel(encoding_of(e), n, r);
}
glm::dvec3 stored_normal(NormalEncoding e, const glm::dvec3& n, StoreRounding r) { return read_back(e, n, r); }
glm::vec3 stored_normal(NormalEncoding e, const glm::vec3& n, StoreRounding r) { return read_back(e, n, r); }

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  // acos loses half the digits near 0; the cross product does not.
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace gbl
