// Axes as colours that repeat, smoothly, and with an edge nowhere: planes at 0 are common.
vec3 value(ivec2 texel) { return read_surface(texel).position + camera_position.xyz; }

vec4 shown(ivec2 texel) {
  vec3 turns = fract(value(texel) / position_cycle.x) + vec3(0.0, 1.0, 2.0) / 3.0;
  return on_surfaces(texel, 0.5 + 0.5 * sin(6.2831853 * turns));
}

vec4 raw(ivec2 texel) {
#ifdef STORED_POSITION
  return vec4(texelFetch(gbuffer_position, texel, 0).rgb, 1.0);
#else
  return vec4(vec3(read_depth(texel)), 1.0);
#endif
}
