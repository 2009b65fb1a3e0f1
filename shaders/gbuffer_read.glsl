// The G-buffer as the lighting, the views and the probe read it: by texel, never filtered.
#include "surface.glsl"
#include "position.glsl"

uniform sampler2D gbuffer_material;
uniform NORMAL_SAMPLER gbuffer_normal;
uniform sampler2D gbuffer_depth;
#if MATERIAL_TARGETS > 1
uniform sampler2D gbuffer_reflectance;
uniform sampler2D gbuffer_emission;
#endif

Surface read_surface(ivec2 texel) {
  Surface s;
  float depth = texelFetch(gbuffer_depth, texel, 0).r;
  s.present = depth < 1.0;
  s.position = position_of(ndc_of_pixel(vec2(texel) + 0.5), depth);
  s.normal = unpack_normal(texelFetch(gbuffer_normal, texel, 0));
  unpack_material(texelFetch(gbuffer_material, texel, 0), s);
#if MATERIAL_TARGETS > 1
  vec4 reflectance = texelFetch(gbuffer_reflectance, texel, 0);
  s.f0 = reflectance.rgb;
  s.occlusion = reflectance.a;
  s.emissive = texelFetch(gbuffer_emission, texel, 0).rgb;
#endif
  return s;
}
