// sRGB-coded, as pictures are.
vec3 value(ivec2 texel) { return read_surface(texel).albedo; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, coded_from_linear(value(texel))); }

vec4 raw(ivec2 texel) {
#ifdef STORED_MATERIAL
  return vec4(raw_texel(texelFetch(gbuffer_material, texel, 0)).rgb, 1.0);
#else
  return raw_lit(texel);
#endif
}
