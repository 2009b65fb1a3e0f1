// How a normal lies in the texels of its encoding, and is read back.
#include "shared.h"
#include "normal_encoding.glsl"

// ENCODE_NORMAL and DECODE_NORMAL name the pair of functions of the encoding's row; NORMAL_STORAGE says how its code
// lies in a texel, NORMAL_BITS how many bits a channel of it has.
#if NORMAL_SPACE == SPACE_VIEW
vec3 stored_from_world(vec3 n) { return mat3(view_from_world) * n; }
#if MISTAKE_MIXED_SPACES
vec3 world_from_stored(vec3 n) { return n; }
#else
vec3 world_from_stored(vec3 n) { return n * mat3(view_from_world); }  // a rotation: the transpose turns it back
#endif
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
