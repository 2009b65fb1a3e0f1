// A surface point: what lighting needs to know of it.
#include "shared.h"
#include "colour.glsl"

struct Surface {
  bool present;      // false: background, the rest means nothing
  vec3 position;     // relative to the camera, world axes
  vec3 normal;       // world, unit
  vec3 albedo;       // linear: base colour x (1 - metal)
  vec3 f0;           // colour of the highlight: reflectance at normal incidence
  float metal;       // 0..1
  float roughness;   // perceptual, 0..1
  float exponent;    // of (Blinn-)Phong's highlight
  vec3 ambient;      // share of ambient light that it sends back
  vec3 emissive;     // radiance
  float occlusion;   // of ambient light, 0..1
};

const float kCommonReflectance = 0.04;  // of index 1.5, which is glTF's default

// What is no metal reflects this much unless its material says more; in the classic models the highlight's factor.
float dielectric_f0() {
#if SHADING_MODEL == MODEL_GGX
  return kCommonReflectance;
#else
  return shading.y;
#endif
}

// The base colour, and the reflectance of what is no metal: albedo = base (1 - metal), F0 = mix(reflectance, base, metal).
vec3 base_of(Surface s) { return s.metal < 1.0 ? s.albedo / (1.0 - s.metal) : s.f0; }
vec3 dielectric_of(Surface s) {
  return s.metal < 1.0 ? max(s.f0 - base_of(s) * s.metal, vec3(0.0)) / (1.0 - s.metal) : vec3(dielectric_f0());
}

// Ambient light comes from everywhere, so it is sent back by albedo and F0 alike: metals are dim, not black. The
// classic models' highlight is no reflectance, so there only a metal's part of it counts.
vec3 ambient_of(Surface s) {
#if SHADING_MODEL == MODEL_GGX
  return s.occlusion * (s.albedo + s.f0);
#else
  return s.occlusion * base_of(s);
#endif
}

// Blinn-Phong exponent. 2/alpha^2 - 2 with alpha = roughness^2 matches the lobe of a microfacet surface
// (Walter et al. 2007, "Microfacet models for refraction through rough surfaces", section 5.2).
float exponent_from_roughness(float roughness) {
  float alpha = roughness * roughness;
  return clamp(2.0 / max(alpha * alpha, 1e-8) - 2.0, 1.0, 8192.0);
}
float roughness_from_exponent(float exponent) { return pow(2.0 / (exponent + 2.0), 0.25); }
float exponent_of(float roughness) { return shading.x >= 0.0 ? shading.x : exponent_from_roughness(roughness); }
