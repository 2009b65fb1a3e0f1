// Unit normals to codes and back: encode_x and decode_x for every row x of normal.encoding (a - in its id is a _ here).
// Written in the subset common to GLSL and C++ with GLM (free functions, no swizzles, no out parameters), so that the
// code that ships is the code the unit tests measure: C++ includes it twice, with real = float and real = double.
//
// A code is a vec3 of whole numbers 0..levels for integer formats (unused channels 0), so the rounding is ours and
// the same on CPU, GPU and web; float formats hold the value itself and the store rounds. That is why sums are spelt
// out and angles are made of + - * / alone: dot(), cross() and atan() differ in their last bit from machine to machine.

real sign_not_zero(real x) { return x < real(0.0) ? real(-1.0) : real(1.0); }
real square(real x) { return x * x; }
real length2(vec3 v) { return square(v.x) + square(v.y) + square(v.z); }

// Nearest whole number, halves up: one definition everywhere (GLSL leaves the halves of round() open).
real nearest(real x) { return floor(x + real(0.5)); }

// -1..1 <-> 0..levels; with an even number of levels 0, hence every axis, has a code.
real code_from_snorm(real x, real levels) {
  return nearest(clamp(x * real(0.5) + real(0.5), real(0.0), real(1.0)) * levels);
}
real snorm_from_code(real c, real levels) { return c / levels * real(2.0) - real(1.0); }
vec3 codes_from_snorms(vec3 v, real levels) {
  return vec3(code_from_snorm(v.x, levels), code_from_snorm(v.y, levels), code_from_snorm(v.z, levels));
}
vec3 snorms_from_codes(vec3 c, real levels) {
  return vec3(snorm_from_code(c.x, levels), snorm_from_code(c.y, levels), snorm_from_code(c.z, levels));
}

// Squared sine of the angle between v and the unit vector n: unlike the cosine it tells small angles apart.
real sine2(vec3 v, vec3 n) {
  return length2(vec3(v.y * n.z - v.z * n.y, v.z * n.x - v.x * n.z, v.x * n.y - v.y * n.x)) / length2(v);
}

// Codes of one to three channels in one word, `bits` each, x lowest.
uint word_from_code(vec3 code, int bits) {
  return uint(code.x) | (uint(code.y) << bits) | (uint(code.z) << (2 * bits));
}
vec3 code_from_word(uint word, int bits) {
  uint mask = (1u << bits) - 1u;
  return vec3(real(word & mask), real((word >> bits) & mask), real((word >> (2 * bits)) & mask));
}

// The pairs, by what they are made of.
#include "normal_xyz.glsl"
#include "normal_projection.glsl"
#include "normal_octahedral.glsl"
