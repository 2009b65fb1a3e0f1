// Axes as colours that repeat.
vec4 shown(ivec2 texel) {
  return on_surfaces(texel, fract((read_surface(texel).position + camera_position.xyz) / view_range.z));
}

vec4 raw(ivec2 texel) {
#ifdef STORED_POSITION
  return vec4(texelFetch(gbuffer_position, texel, 0).rgb, 1.0);
#else
  return vec4(vec3(read_depth(texel)), 1.0);
#endif
}
