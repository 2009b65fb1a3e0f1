// A surface point, and how it is packed into the G-buffer and read back. One pack/unpack pair per layout.
#include "shared.h"
#include "normal_encoding.glsl"
#include "colour.glsl"

struct Surface {
  bool present;      // false: background, the rest means nothing
  vec3 position;     // relative to the camera, world axes
  vec3 normal;       // world, unit
  vec3 albedo;       // linear: base colour x (1 - metal)
  vec3 f0;           // reflectance at normal incidence
  float roughness;   // perceptual, 0..1
  vec3 emissive;     // radiance
  float occlusion;   // of ambient light, 0..1
};

// The classic models know no reflectance of dielectrics: their highlight is shading.specular.
#if SHADING_MODEL == MODEL_GGX
const float kDielectricF0 = 0.04;
#else
const float kDielectricF0 = 0.0;
#endif

// A layout without roughness: as if every surface were this rough.
const float kRoughnessNotStored = 0.5;

// ---- material: what each layout keeps; the rest is as unpack_material says ---------------------------------
#if LAYOUT == LAYOUT_FLOAT32
#define MATERIAL_TARGETS 3
#else
#define MATERIAL_TARGETS 1
#endif

vec4 pack_material(Surface s) {
#if LAYOUT == LAYOUT_ALBEDO_ROUGHNESS
  return vec4(quantised8(coded_from_linear(s.albedo)), quantised8(vec3(s.roughness)).x);
#elif LAYOUT == LAYOUT_NCLGL
  return vec4(quantised8(coded_from_linear(s.albedo)), 1.0);
#else
  return vec4(s.albedo, s.roughness);
#endif
}
vec4 pack_reflectance(Surface s) { return vec4(s.f0, s.occlusion); }
vec4 pack_emission(Surface s) { return vec4(s.emissive, 1.0); }

void unpack_material(vec4 stored, inout Surface s) {
  s.f0 = vec3(kDielectricF0);
  s.emissive = vec3(0.0);
  s.occlusion = 1.0;
#if LAYOUT == LAYOUT_FLOAT32
  s.albedo = stored.rgb;
  s.roughness = stored.a;
#else
  s.albedo = linear_from_coded(stored.rgb);
#if LAYOUT == LAYOUT_ALBEDO_ROUGHNESS
  s.roughness = stored.a;
#else
  s.roughness = kRoughnessNotStored;
#endif
#endif
}

// ---- normal ----------------------------------------------------------------------------------------------
#if NORMAL_ENCODING == NORMAL_OCT16
#define NORMAL_SAMPLER usampler2D
#define NORMAL_OUTPUT uvec4
uvec4 pack_normal(vec3 n) { return uvec4(uvec3(encode_oct16(n)), 0u); }
vec3 unpack_normal(uvec4 stored) { return decode_oct16(vec3(stored.xyz)); }
vec4 raw_normal(uvec4 stored) { return vec4(vec2(stored.xy) / 65535.0, 0.0, 1.0); }
#else
#define NORMAL_SAMPLER sampler2D
#define NORMAL_OUTPUT vec4
vec4 raw_normal(vec4 stored) { return vec4(stored.xyz, 1.0); }
#if NORMAL_ENCODING == NORMAL_OCT8
vec4 pack_normal(vec3 n) { return vec4(encode_oct8(n) / 255.0, 0.0); }
vec3 unpack_normal(vec4 stored) { return decode_oct8(floor(stored.xyz * 255.0 + 0.5)); }
#elif NORMAL_ENCODING == NORMAL_XYZ8
vec4 pack_normal(vec3 n) { return vec4(encode_xyz8(n) / 255.0, 1.0); }
vec3 unpack_normal(vec4 stored) { return decode_xyz8(floor(stored.xyz * 255.0 + 0.5)); }
#elif NORMAL_ENCODING == NORMAL_STEREO16F
vec4 pack_normal(vec3 n) { return vec4(encode_stereo16f(n).xy, 0.0, 0.0); }
vec3 unpack_normal(vec4 stored) { return decode_stereo16f(vec3(stored.xy, 0.0)); }
#endif
#endif
