// sRGB-coded, as pictures are.
vec3 value(ivec2 texel) { return read_surface(texel).f0; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, coded_from_linear(value(texel))); }

vec4 raw(ivec2 texel) {
#ifdef STORED_REFLECTANCE
  return raw_texel(texelFetch(gbuffer_reflectance, texel, 0));
#elif defined(STORED_MATERIAL)
  return raw_texel(texelFetch(gbuffer_material, texel, 0));
#else
  return raw_lit(texel);
#endif
}
