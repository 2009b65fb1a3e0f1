// What layouts are packed of: codes of some bits, codes of 8 bits, emission and exponents by a rule of their own.
#include "surface.glsl"

uint bits_of(float x, int bits) {
  float levels = float((1 << bits) - 1);
  return uint(floor(clamp(x, 0.0, 1.0) * levels + 0.5));
}
float float_of(uint word, int first, int bits) {
  return float((word >> uint(first)) & uint((1 << bits) - 1)) / float((1 << bits) - 1);
}

vec3 coded8(vec3 linear) { return quantised8(coded_from_linear(linear)); }
#if MISTAKE_LINEAR_ALBEDO_8BIT
vec3 albedo8(vec3 linear) { return quantised8(clamp(linear, 0.0, 1.0)); }
vec3 albedo_of8(vec3 stored) { return stored; }
#else
vec3 albedo8(vec3 linear) { return coded8(linear); }
vec3 albedo_of8(vec3 stored) { return linear_from_coded(stored); }
#endif
float kept8(float x) { return quantised8(vec3(x)).x; }

// Emission is kept as the display shows it: what is above its white is lost, what is below it has the eye's steps.
vec3 shown_emission(Surface s) { return coded_from_linear(min(s.emissive * shading.w, vec3(1.0))); }
vec3 emission_of_shown(vec3 coded) { return linear_from_coded(coded) / shading.w; }

// The exponent that a layout with one stores. GGX reads it back as a roughness.
float stored_exponent(Surface s) {
#if SHADING_MODEL == MODEL_GGX
  return exponent_from_roughness(s.roughness);
#else
  return s.exponent;
#endif
}
void set_exponent(inout Surface s, float exponent) {
  s.exponent = exponent;
  s.roughness = roughness_from_exponent(exponent);
}
void set_roughness(inout Surface s, float roughness) {
  s.roughness = roughness;
  s.exponent = exponent_of(roughness);
}

// Base colour and metal, as glTF has them; F0 was what the surface reflects where it is no metal.
void set_base(inout Surface s, vec3 base) {
  s.albedo = base * (1.0 - s.metal);
  s.f0 = mix(s.f0, base, s.metal);
}
