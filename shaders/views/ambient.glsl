// sRGB-coded, as it is stored.
vec3 value(ivec2 texel) { return read_surface(texel).ambient; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, coded_from_linear(value(texel))); }

vec4 raw(ivec2 texel) {
#ifdef STORED_AMBIENT
  return texelFetch(gbuffer_ambient, texel, 0);
#else
  return raw_lit(texel);
#endif
}
