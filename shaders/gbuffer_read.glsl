// The G-buffer as the lighting, the views and the probe read it: by texel, never filtered. What a method does not
// store is left out here: forward shading has depth alone.
#include "packing.glsl"
#include "position.glsl"

uniform sampler2D gbuffer_depth;
#ifdef STORED_POSITION
uniform sampler2D gbuffer_position;
#endif
#ifdef STORED_NORMAL
uniform NORMAL_SAMPLER gbuffer_normal;
#endif
#ifdef STORED_MATERIAL
uniform MATERIAL_SAMPLER gbuffer_material;
#ifdef STORED_REFLECTANCE
uniform MATERIAL_SAMPLER gbuffer_reflectance;
#endif
#ifdef STORED_EMISSION
uniform MATERIAL_SAMPLER gbuffer_emission;
#endif
#ifdef STORED_AMBIENT
uniform sampler2D gbuffer_ambient;
#endif
#ifdef STORED_SHININESS
uniform sampler2D gbuffer_shininess;
#endif

Stored read_stored(ivec2 texel) {
  Stored t;
  t.material = texelFetch(gbuffer_material, texel, 0);
#ifdef STORED_REFLECTANCE
  t.reflectance = texelFetch(gbuffer_reflectance, texel, 0);
#endif
#ifdef STORED_EMISSION
  t.emission = texelFetch(gbuffer_emission, texel, 0);
#endif
#ifdef STORED_AMBIENT
  t.ambient = texelFetch(gbuffer_ambient, texel, 0);
#endif
#ifdef STORED_SHININESS
  t.shininess = texelFetch(gbuffer_shininess, texel, 0);
#endif
  return t;
}
#endif

float read_depth(ivec2 texel) { return texelFetch(gbuffer_depth, texel, 0).r; }

// Is there a surface? As background.skip says; the views always ask the depth.
bool read_present(ivec2 texel) {
#if BACKGROUND_SKIP == SKIP_NONE
  return true;
#elif BACKGROUND_SKIP == SKIP_ALPHA && defined(STORED_AMBIENT)
  return texelFetch(gbuffer_ambient, texel, 0).a >= 0.1;
#elif BACKGROUND_SKIP == SKIP_ALPHA && defined(STORED_MATERIAL) && !MATERIAL_WORDS
  return texelFetch(gbuffer_material, texel, 0).a >= 0.1;
#else
  return read_depth(texel) != kFarDepth;
#endif
}

vec3 read_position(ivec2 texel) {
  vec2 ndc = ndc_of_pixel(vec2(texel) + 0.5);
#ifdef STORED_POSITION
  return unpack_position(texelFetch(gbuffer_position, texel, 0), ndc);
#else
  return position_from_depth(ndc, read_depth(texel));
#endif
}

Surface read_surface(ivec2 texel) {
#ifdef STORED_MATERIAL
  Surface s = unstored_surface();
  Stored t = read_stored(texel);
  unpack_material(t, s);
#if NORMAL_IN_MATERIAL
  s.normal = normal_of_word(stored_normal_word(t.material));
#else
  s.normal = unpack_normal(texelFetch(gbuffer_normal, texel, 0));
#endif
#else
  const vec3 zero = vec3(0.0);
  Surface s = Surface(false, zero, zero, zero, zero, 0.0, 0.0, 0.0, zero, zero, 0.0);
#endif
  s.present = read_present(texel);
  s.position = read_position(texel);
  return s;
}
