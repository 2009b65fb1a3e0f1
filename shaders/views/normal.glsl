// Axes as colours: -1..1 is 0..1.
vec3 value(ivec2 texel) { return read_surface(texel).normal; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, value(texel) * 0.5 + 0.5); }

vec4 raw(ivec2 texel) {
#ifdef STORED_NORMAL
  return raw_normal(texelFetch(gbuffer_normal, texel, 0));
#elif NORMAL_IN_MATERIAL
  return raw_normal(uvec4(stored_normal_word(texelFetch(gbuffer_material, texel, 0)), 0u, 0u, 0u));
#else
  return raw_lit(texel);
#endif
}
