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

// ---- normal ------------------------------------------------------------------------------------------------
// ENCODE_NORMAL and DECODE_NORMAL name the pair of functions of the encoding's row; NORMAL_STORAGE says how its code
// lies in a texel, NORMAL_BITS how many bits a channel of it has.
#if NORMAL_SPACE == SPACE_VIEW
vec3 stored_from_world(vec3 n) { return mat3(view_from_world) * n; }
vec3 world_from_stored(vec3 n) { return n * mat3(view_from_world); }  // a rotation: the transpose turns it back
#else
vec3 stored_from_world(vec3 n) { return n; }
vec3 world_from_stored(vec3 n) { return n; }
#endif

#if NORMAL_STORAGE == STORAGE_UNORM8 || NORMAL_STORAGE == STORAGE_FLOATS
#define NORMAL_SAMPLER sampler2D
#define NORMAL_OUTPUT vec4
#else
#define NORMAL_SAMPLER usampler2D
#define NORMAL_OUTPUT uvec4
#endif

#if NORMAL_STORAGE == STORAGE_UNORM8
vec4 texel_from_code(vec3 code) { return vec4(code / 255.0, 1.0); }
vec3 code_from_texel(vec4 stored) { return floor(stored.xyz * 255.0 + 0.5); }
#elif NORMAL_STORAGE == STORAGE_UINTS
uvec4 texel_from_code(vec3 code) { return uvec4(uvec3(code), 0u); }
vec3 code_from_texel(uvec4 stored) { return vec3(stored.xyz); }
#elif NORMAL_STORAGE == STORAGE_WORD
uint word_from_code(vec3 code) { return word_from_code(code, NORMAL_BITS); }
vec3 code_from_word(uint word) { return code_from_word(word, NORMAL_BITS); }
uvec4 texel_from_code(vec3 code) { return uvec4(word_from_code(code), 0u, 0u, 0u); }
vec3 code_from_texel(uvec4 stored) { return code_from_word(stored.x); }
#else
vec4 texel_from_code(vec3 code) { return vec4(code, 1.0); }
vec3 code_from_texel(vec4 stored) { return stored.xyz; }
#endif

NORMAL_OUTPUT pack_normal(vec3 n) { return texel_from_code(ENCODE_NORMAL(stored_from_world(n))); }
vec3 unpack_normal(NORMAL_OUTPUT stored) { return world_from_stored(DECODE_NORMAL(code_from_texel(stored))); }

#if NORMAL_STORAGE == STORAGE_WORD
// For a layout that keeps the normal in a word of its own, beside other bits; those above the code's are ignored.
uint normal_word(vec3 n) { return pack_normal(n).x; }
vec3 normal_of_word(uint word) { return unpack_normal(uvec4(word, 0u, 0u, 0u)); }
#endif

// The code as a colour.
vec4 raw_normal(NORMAL_OUTPUT stored) {
#if NORMAL_STORAGE == STORAGE_FLOATS
  return vec4(code_from_texel(stored), 1.0);
#else
  return vec4(code_from_texel(stored) / float((1 << NORMAL_BITS) - 1), 1.0);
#endif
}

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
