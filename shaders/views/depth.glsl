// Distance along the view axis, from dark to light.
vec4 shown(ivec2 texel) {
  float range = range_from_depth(read_depth(texel));
  return on_surfaces(texel, vec3(clamp((range - view_range.x) / (view_range.y - view_range.x), 0.0, 1.0)));
}

vec4 raw(ivec2 texel) { return vec4(vec3(read_depth(texel)), 1.0); }
