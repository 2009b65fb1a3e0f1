// A surface point, and how it is packed into the G-buffer and read back. One pack/unpack pair per layout.
#include "shared.h"
#include "normal_encoding.glsl"
#include "colour.glsl"

struct Surface {
  bool present;      // false: background, the rest means nothing
  vec3 position;     // relative to the camera, world axes
  vec3 normal;       // world, unit
  vec3 albedo;       // linear
  float roughness;   // perceptual, 0..1
};

// A layout without roughness: as if every surface were this rough.
const float kRoughnessNotStored = 0.5;

// ---- material: one RGBA8 in both layouts -----------------------------------------------------------------
vec4 pack_material(Surface s) {
#if LAYOUT == LAYOUT_ALBEDO_ROUGHNESS
  return vec4(quantised8(coded_from_linear(s.albedo)), quantised8(vec3(s.roughness)).x);
#elif LAYOUT == LAYOUT_NCLGL
  return vec4(quantised8(coded_from_linear(s.albedo)), 1.0);
#endif
}

void unpack_material(vec4 stored, inout Surface s) {
  s.albedo = linear_from_coded(stored.rgb);
#if LAYOUT == LAYOUT_ALBEDO_ROUGHNESS
  s.roughness = stored.a;
#else
  s.roughness = kRoughnessNotStored;
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
