// From dark to light over what is seen.
vec3 value(ivec2 texel) { return vec3(read_surface(texel).exponent); }

vec4 shown(ivec2 texel) { return on_surfaces(texel, clamp(of_range(value(texel)), 0.0, 1.0)); }

vec4 raw(ivec2 texel) {
#ifdef STORED_SHININESS
  return texelFetch(gbuffer_shininess, texel, 0);
#else
  return raw_lit(texel);
#endif
}
