#include "renderer/gbuffer/normal_encoding.h"

#include <cmath>
#include <limits>

#include "renderer/gbuffer/normal_code.h"
#include "renderer/rows/value_table.h"

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
#define ENCODING(name, ...) \
  {{__VA_ARGS__}, {f32::encode_##name, f32::decode_##name}, {f64::encode_##name, f64::decode_##name}},
constexpr Encoding kEncodings[] = {
#include "renderer/gbuffer/normal_encodings.inc"
};
#undef ENCODING
constexpr auto kValues = values_of<kEncodings>([](const Encoding& e) { return e.row.axis; });

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

GBL_ROWS(NormalEncoding, kValues)

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
glm::dvec3 normal_of_code(NormalEncoding e, const glm::dvec3& code) { return encoding_of(e).f64.decode(code); }
glm::dvec3 stored_normal(NormalEncoding e, const glm::dvec3& n, StoreRounding r) { return read_back(e, n, r); }
glm::vec3 stored_normal(NormalEncoding e, const glm::vec3& n, StoreRounding r) { return read_back(e, n, r); }

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  // acos loses half the digits near 0; the cross product does not.
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace gbl
