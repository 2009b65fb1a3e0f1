// Compiled for processors with AVX2 and fused multiply-add (CMakeLists.txt), so it includes nothing that others inline.
#include "app/pair_blocks.h"

namespace gbl {
namespace {

using Vector = float __attribute__((vector_size(4 * kLanes)));
using Words = int __attribute__((vector_size(4 * kLanes)));

// Vectors that are handed over in memory would be measured, too.
#define INLINE [[gnu::always_inline]] inline

// A number of each pixel.
struct Eight {
  Vector v;
  Eight() = default;
  Eight(Vector of) : v(of) {}                                   // NOLINT(google-explicit-constructor)
  Eight(double all) : v(Vector{} + static_cast<float>(all)) {}  // NOLINT(google-explicit-constructor)
  explicit Eight(const float* from) { __builtin_memcpy(&v, from, sizeof v); }
  void store(float* to) const { __builtin_memcpy(to, &v, sizeof v); }
};
INLINE Eight operator+(Eight a, Eight b) { return a.v + b.v; }
INLINE Eight operator-(Eight a, Eight b) { return a.v - b.v; }
INLINE Eight operator*(Eight a, Eight b) { return a.v * b.v; }
INLINE Eight operator/(Eight a, Eight b) { return a.v / b.v; }
INLINE Eight max(Eight a, Eight b) { return a.v > b.v ? a.v : b.v; }
INLINE Eight min(Eight a, Eight b) { return a.v < b.v ? a.v : b.v; }
INLINE Eight clamp(Eight x, Eight low, Eight high) { return min(max(x, low), high); }
INLINE Eight if_less(Eight a, Eight b, Eight x) { return a.v < b.v ? x.v : Vector{}; }
INLINE Eight step(Eight edge, Eight x) { return edge.v <= x.v ? Eight(1.0).v : Vector{}; }
INLINE Eight sqrt(Eight a) {
  Eight r;
  for (int k = 0; k < kLanes; ++k) r.v[k] = __builtin_sqrtf(a.v[k]);
  return r;
}
INLINE Eight inversesqrt(Eight a) { return Eight(1.0) / sqrt(a); }

// 2^x for |x| <= 126: a whole number for the exponent's bits, and a series for the rest.
INLINE Eight exp2(Eight x) {
  x = clamp(x, -126.0, 126.0);
  const Words whole = __builtin_convertvector((x + 126.5).v, Words) - 126;  // the nearest
  const Eight t = (x - Eight(__builtin_convertvector(whole, Vector))) * 0.69314718056;
  const Eight part = ((((t * (1 / 720.0) + 1 / 120.0) * t + 1 / 24.0) * t + 1 / 6.0) * t + 0.5) * t * t + t + 1.0;
  return part * Eight(reinterpret_cast<Vector>((whole + 127) << 23));
}

// Of positive numbers: the exponent's bits, and the series of artanh for what lies between 1/sqrt(2) and sqrt(2).
INLINE Eight log2(Eight x) {
  const Words bits = reinterpret_cast<Words>(x.v) - 0x3f3504f3;
  const Eight m(reinterpret_cast<Vector>((bits & 0x007fffff) + 0x3f3504f3));
  const Eight t = (m - 1.0) / (m + 1.0), t_2 = t * t;
  const Eight part = (((t_2 * (1 / 9.0) + 1 / 7.0) * t_2 + 1 / 5.0) * t_2 + 1 / 3.0) * t_2 + 1.0;
  return Eight(__builtin_convertvector(bits >> 23, Vector)) + t * part * 2.8853900817779268;
}

struct Three {
  Eight x, y, z;
  Three() = default;
  explicit Three(Eight all) : x(all), y(all), z(all) {}
  Three(Eight a, Eight b, Eight c) : x(a), y(b), z(c) {}
};
INLINE Three operator+(const Three& a, const Three& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
INLINE Three operator-(const Three& a, const Three& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
INLINE Three operator*(const Three& a, const Three& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
INLINE Three operator*(const Three& a, Eight b) { return {a.x * b, a.y * b, a.z * b}; }
INLINE Eight dot(const Three& a, const Three& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

using real = Eight;
using lane = Eight;
using vec3 = Three;
using lane3 = Three;
INLINE Three in_all_lanes(const Three& v) { return v; }
INLINE Eight dots(const Three& a, const Three& b) { return dot(a, b); }
INLINE Eight squares(const Three& a) { return dot(a, a); }
INLINE Three scaled(const Three& a, Eight by) { return a * by; }
INLINE Three weighted_sum(const Three& a, Eight weight) { return a * weight; }
INLINE Three weighted_sum(const Three& a, const Three& weight) { return a * weight; }
INLINE Three times(Eight a, const Three& b) { return b * a; }

INLINE Three three_of(const float (&from)[3][kLanes]) { return {Eight(from[0]), Eight(from[1]), Eight(from[2])}; }
INLINE Three three_of(const float (&all)[3]) {
  return {Eight(double(all[0])), Eight(double(all[1])), Eight(double(all[2]))};
}
INLINE void store(const Three& v, float (&to)[3][kLanes]) { v.x.store(to[0]), v.y.store(to[1]), v.z.store(to[2]); }

#define PAIR_TEXT "app/pair_loops_text.inc"
#include "renderer/light/pair_variants.inc"

struct Variant {
  int model, attenuation;
  PairLoop loop;
};
constexpr Variant kVariants[] = {
    {MODEL_LAMBERT, ATTENUATION_LINEAR, lambert_linear::add_lights},
    {MODEL_PHONG, ATTENUATION_LINEAR, phong_linear::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_LINEAR, blinn_phong_linear::add_lights},
    {MODEL_GGX, ATTENUATION_LINEAR, ggx_linear::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_NONE, blinn_phong_none::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_QUADRATIC, blinn_phong_quadratic::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_RAMP, blinn_phong_ramp::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_INVERSE_LINEAR, blinn_phong_inverse_linear::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_WINDOWED, blinn_phong_windowed::add_lights},
    {MODEL_BLINN_PHONG, ATTENUATION_GLTF, blinn_phong_gltf::add_lights},
};

}  // namespace

PairLoop pair_loop(int model, int attenuation) {
  for (const Variant& v : kVariants)
    if (v.model == model && v.attenuation == attenuation) return v.loop;
  return nullptr;
}

}  // namespace gbl
