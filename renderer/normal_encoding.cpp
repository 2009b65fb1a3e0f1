#include "renderer/normal_encoding.h"

#include <cmath>
#include <glm/gtc/packing.hpp>

// The shader's text twice. GLM supplies GLSL's functions; `real` is the one word that differs.
namespace gbl::f32 {
namespace {
using real = float;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using glm::abs, glm::clamp, glm::floor, glm::normalize;
#include "shaders/normal_encoding.glsl"
}  // namespace
}  // namespace gbl::f32
namespace gbl::f64 {
namespace {
using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using glm::abs, glm::clamp, glm::floor, glm::normalize;
#include "shaders/normal_encoding.glsl"
}  // namespace
}  // namespace gbl::f64

namespace gbl {
namespace {

// Degrees; measured by tests/normal_encoding_test, which fails if they drift.
constexpr EncodingRow kRows[] = {
    {NormalEncoding::oct16, 32, 0.00131, 0.00293, 0.00371},
    {NormalEncoding::oct8, 16, 0.337, 0.758, 0.957},
    {NormalEncoding::xyz8, 24, 0.170, 0.318, 0.389},
    {NormalEncoding::stereo16f, 32, 0.00833, 0.0212, 0.0280},
};

template <class V>
V rounded_to_half(const V& v) {
  V out = v;
  for (int k = 0; k < 2; ++k)
    out[k] = static_cast<typename V::value_type>(glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(v[k]))));
  return out;
}

}  // namespace

const EncodingRow& row_of(NormalEncoding e) { return kRows[static_cast<int>(e)]; }

#define STORED(space, V)                                                                                         \
  switch (e) {                                                                                                   \
    case NormalEncoding::oct16: return space::decode_oct16(space::encode_oct16(n));                              \
    case NormalEncoding::oct8: return space::decode_oct8(space::encode_oct8(n));                                 \
    case NormalEncoding::xyz8: return space::decode_xyz8(space::encode_xyz8(n));                                 \
    case NormalEncoding::stereo16f: return space::decode_stereo16f(rounded_to_half(space::encode_stereo16f(n))); \
  }                                                                                                              \
  return V(0)

glm::dvec3 stored_normal_f64(NormalEncoding e, const glm::dvec3& n) { STORED(f64, glm::dvec3); }
glm::vec3 stored_normal_f32(NormalEncoding e, const glm::vec3& n) { STORED(f32, glm::vec3); }
#undef STORED

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  // acos loses half the digits near 0; the cross product does not.
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace gbl
