// Dark where the surface is no metal.
vec3 value(ivec2 texel) { return vec3(read_surface(texel).metal); }

vec4 shown(ivec2 texel) { return on_surfaces(texel, clamp(value(texel), 0.0, 1.0)); }

vec4 raw(ivec2 texel) {
#ifdef STORED_REFLECTANCE
  return raw_texel(texelFetch(gbuffer_reflectance, texel, 0));
#elif defined(STORED_MATERIAL)
  return raw_texel(texelFetch(gbuffer_material, texel, 0));
#else
  return raw_lit(texel);
#endif
}
