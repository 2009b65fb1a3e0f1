// A surface point, and how it is packed into the G-buffer and read back. One pack/unpack pair per layout.
// STORED_X is defined for each attachment of the geometry pass, as its draw buffer.
#include "shared.h"
#include "normal_encoding.glsl"
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

// What is no metal reflects this much; in the classic models the factor of the highlight.
float dielectric_f0() {
#if SHADING_MODEL == MODEL_GGX
  return 0.04;
#else
  return shading.y;
#endif
}

// Base colour = albedo + the metal's part of F0.
vec3 base_of(Surface s) { return max(s.albedo + s.f0 - dielectric_f0() * (1.0 - s.metal), vec3(0.0)); }

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
vec3 unpack_normal(NORMAL_OUTPUT stored) {
#if MISTAKE_DECODE_NOT_NORMALISED && NORMAL_STORAGE == STORAGE_UNORM8 && NORMAL_CHANNELS == 3
  return world_from_stored(code_from_texel(stored) / 255.0 * 2.0 - 1.0);
#else
  return world_from_stored(DECODE_NORMAL(code_from_texel(stored)));
#endif
}

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

// What a texel of the material holds: numbers, or words of packed bits.
#if MATERIAL_WORDS
#define MATERIAL_TEXEL uvec4
#define MATERIAL_SAMPLER usampler2D
#else
#define MATERIAL_TEXEL vec4
#define MATERIAL_SAMPLER sampler2D
#endif

// ---- bits --------------------------------------------------------------------------------------------------
uint bits_of(float x, int bits) {
  float levels = float((1 << bits) - 1);
  return uint(floor(clamp(x, 0.0, 1.0) * levels + 0.5));
}
float float_of(uint word, int first, int bits) {
  return float((word >> uint(first)) & uint((1 << bits) - 1)) / float((1 << bits) - 1);
}

// Emission is kept as the display shows it: what is above its white is lost, what is below it has the eye's steps.
vec3 shown_emission(Surface s) { return coded_from_linear(min(s.emissive * shading.w, vec3(1.0))); }
vec3 emission_of_shown(vec3 coded) { return linear_from_coded(coded) / shading.w; }

// ---- material: what each layout keeps; the rest is as unpack_material says ---------------------------------
vec3 coded8(vec3 linear) { return quantised8(coded_from_linear(linear)); }
float kept8(float x) { return quantised8(vec3(x)).x; }

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

#if THIN
// Deferred lighting: what the light passes need, and nothing else.
vec4 pack_material(Surface s) {
#if LAYOUT == LAYOUT_FLOAT32
  return vec4(s.f0, s.roughness);
#else
  return quantised8(vec4(s.f0, s.roughness));
#endif
}
#elif LAYOUT == LAYOUT_COMPACT || LAYOUT == LAYOUT_COMPACT_METAL
// The word of an encoding that shares the texel stands in bits 0-27.
uvec4 pack_material(Surface s) {
#if LAYOUT == LAYOUT_COMPACT
  vec3 c = coded_from_linear(s.albedo);
#else
  vec3 c = coded_from_linear(base_of(s));
#endif
  uint rough = bits_of(s.roughness, 10);
  uint word = 0u;
#if NORMAL_IN_MATERIAL
  word = normal_word(s.normal);
#endif
  return uvec4(word | (rough >> 6) << 28, bits_of(c.r, 9) | bits_of(c.g, 9) << 9 | bits_of(c.b, 8) << 18 | (rough & 63u) << 26, 0u, 0u);
}
#elif LAYOUT == LAYOUT_EXACT || LAYOUT == LAYOUT_EXACT_EMISSION
uvec4 pack_material(Surface s) {
  vec3 c = coded_from_linear(base_of(s));
  uint rough = bits_of(s.roughness, 14);
  return uvec4(bits_of(c.r, 10) | bits_of(c.g, 10) << 10 | bits_of(c.b, 10) << 20 | rough << 30,
               rough >> 2 | bits_of(s.metal, 10) << 12 | bits_of(s.occlusion, 10) << 22, 0u, 0u);
}
#else
vec4 pack_material(Surface s) {
#if LAYOUT == LAYOUT_FLOAT32
  return vec4(s.albedo, s.roughness);
#elif LAYOUT == LAYOUT_ALBEDO_ROUGHNESS
  return vec4(coded8(s.albedo), kept8(s.roughness));
#elif LAYOUT == LAYOUT_LEARNOPENGL
  return vec4(coded8(s.albedo), kept8(max(max(s.f0.r, s.f0.g), s.f0.b)));
#else
  return vec4(coded8(s.albedo), 1.0);
#endif
}
#endif

#ifdef STORED_REFLECTANCE
MATERIAL_TEXEL pack_reflectance(Surface s) {
#if LAYOUT == LAYOUT_COMPACT_METAL
  vec3 c = shown_emission(s);
  uvec3 e = uvec3(bits_of(c.r, 8), bits_of(c.g, 8), bits_of(c.b, 8));
  if ((e.r | e.g | e.b) == 0u) return uvec4(bits_of(s.metal, 10) | bits_of(s.occlusion, 10) << 10, 0u, 0u, 0u);
  return uvec4(e.r | e.g << 8 | e.b << 16 | bits_of(s.metal, 3) << 24 | bits_of(s.occlusion, 4) << 27 | 0x80000000u, 0u, 0u, 0u);
#elif LAYOUT == LAYOUT_FLOAT32
  return vec4(s.f0, s.occlusion);
#elif LAYOUT == LAYOUT_STEREO
  return quantised8(vec4(s.f0, s.roughness));
#elif LAYOUT == LAYOUT_VIEWSPACE
  return quantised8(vec4(s.f0, stored_exponent(s) / 256.0));
#else
  return vec4(quantised8(s.f0), 1.0);
#endif
}
#endif

#ifdef STORED_EMISSION
MATERIAL_TEXEL pack_emission(Surface s) {
#if LAYOUT == LAYOUT_EXACT_EMISSION
  vec3 c = shown_emission(s);
  return uvec4(bits_of(c.r, 11) | bits_of(c.g, 11) << 11 | bits_of(c.b, 10) << 22, 0u, 0u, 0u);
#elif LAYOUT == LAYOUT_STEREO
  return vec4(shading.z * s.ambient + s.emissive, 0.0);
#else
  return vec4(s.emissive, s.metal);
#endif
}
#endif

#ifdef STORED_MATERIAL
// The texels of a layout's attachments.
struct Stored {
  MATERIAL_TEXEL material;
#ifdef STORED_REFLECTANCE
  MATERIAL_TEXEL reflectance;
#endif
#ifdef STORED_EMISSION
  MATERIAL_TEXEL emission;
#endif
#ifdef STORED_AMBIENT
  vec4 ambient;
#endif
#ifdef STORED_SHININESS
  vec4 shininess;
#endif
};

void unpack_material(Stored t, inout Surface s) {
  s.albedo = vec3(0.0);
  s.f0 = vec3(dielectric_f0());
  s.metal = 0.0;
  s.emissive = vec3(0.0);
  s.occlusion = 1.0;
  s.roughness = kRoughnessNotStored;
#if THIN
  s.f0 = t.material.rgb;
  s.roughness = t.material.a;
#elif LAYOUT == LAYOUT_FLOAT32
  s.albedo = t.material.rgb;
  s.roughness = t.material.a;
  s.f0 = t.reflectance.rgb;
  s.occlusion = t.reflectance.a;
  s.emissive = t.emission.rgb;
  s.metal = t.emission.a;
#elif MATERIAL_WORDS
#if LAYOUT == LAYOUT_EXACT || LAYOUT == LAYOUT_EXACT_EMISSION
  vec3 base = linear_from_coded(vec3(float_of(t.material.x, 0, 10), float_of(t.material.x, 10, 10), float_of(t.material.x, 20, 10)));
  s.roughness = float((t.material.y & 4095u) << 2 | t.material.x >> 30) / 16383.0;
  s.metal = float_of(t.material.y, 12, 10);
  s.occlusion = float_of(t.material.y, 22, 10);
#if LAYOUT == LAYOUT_EXACT_EMISSION
  s.emissive = emission_of_shown(vec3(float_of(t.emission.x, 0, 11), float_of(t.emission.x, 11, 11), float_of(t.emission.x, 22, 10)));
#endif
#else
  vec3 base = linear_from_coded(vec3(float_of(t.material.y, 0, 9), float_of(t.material.y, 9, 9), float_of(t.material.y, 18, 8)));
  s.roughness = float((t.material.x >> 28) << 6 | t.material.y >> 26) / 1023.0;
#if LAYOUT == LAYOUT_COMPACT_METAL
  bool shines = t.reflectance.x >> 31 == 1u;
  s.metal = shines ? float_of(t.reflectance.x, 24, 3) : float_of(t.reflectance.x, 0, 10);
  s.occlusion = shines ? float_of(t.reflectance.x, 27, 4) : float_of(t.reflectance.x, 10, 10);
  if (shines) s.emissive = emission_of_shown(vec3(float_of(t.reflectance.x, 0, 8), float_of(t.reflectance.x, 8, 8), float_of(t.reflectance.x, 16, 8)));
#endif
#endif
  s.albedo = base * (1.0 - s.metal);
  s.f0 = mix(s.f0, base, s.metal);
#else
  s.albedo = linear_from_coded(t.material.rgb);
#if LAYOUT == LAYOUT_ALBEDO_ROUGHNESS
  s.roughness = t.material.a;
#elif LAYOUT == LAYOUT_LEARNOPENGL
  s.f0 = vec3(t.material.a);
#elif LAYOUT != LAYOUT_NCLGL
  s.f0 = t.reflectance.rgb;
#if LAYOUT == LAYOUT_STEREO
  s.roughness = t.reflectance.a;
#endif
#endif
#endif
  s.exponent = exponent_of(s.roughness);
#if LAYOUT == LAYOUT_VIEWSPACE && !THIN
  set_exponent(s, t.reflectance.a * 256.0);
#elif LAYOUT == LAYOUT_OBJECTID && !THIN
  set_exponent(s, t.shininess.r);
#endif
#if defined(STORED_AMBIENT)
  s.ambient = linear_from_coded(t.ambient.rgb);
#elif LAYOUT == LAYOUT_LEARNOPENGL && SHADING_MODEL != MODEL_GGX && !THIN
  s.ambient = s.albedo;  // a strength says nothing of metal
#else
  s.ambient = ambient_of(s);
#endif
#if LAYOUT == LAYOUT_STEREO && !THIN
  // Ambient light and emission are in the sum already, or stand beside it.
  s.ambient = vec3(0.0);
#ifdef STORED_EMISSION
  s.emissive = t.emission.rgb;
#endif
#endif
}
#endif
