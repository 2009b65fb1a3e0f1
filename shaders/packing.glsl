// How the material of a surface lies in the texels of the layout, and is read back. LAYOUT_FILE is the layout's own file:
//   Stored pack_material(Surface)                 fills the texels that its row in layouts.inc names
//   void unpack_material(Stored, inout Surface)   sets what was kept; the rest is as unstored_surface() says
// STORED_X is defined for each attachment of the geometry pass, as its draw buffer.
#include "surface.glsl"
#include "normal_texel.glsl"
#include "packed_numbers.glsl"

#ifdef STORED_MATERIAL
// What a texel of the material holds: numbers, or words of packed bits.
#if MATERIAL_WORDS
#define MATERIAL_TEXEL uvec4
#define MATERIAL_SAMPLER usampler2D
#else
#define MATERIAL_TEXEL vec4
#define MATERIAL_SAMPLER sampler2D
#endif

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

// A layout without roughness: as if every surface were this rough.
const float kRoughnessNotStored = 0.5;

Surface unstored_surface() {
  const vec3 zero = vec3(0.0);
  Surface s = Surface(false, zero, zero, zero, vec3(dielectric_f0()), 0.0, 0.0, 0.0, zero, zero, 1.0);
  set_roughness(s, kRoughnessNotStored);
  return s;
}

#include LAYOUT_FILE
#endif
