// Does another object begin to the right or above?
vec3 value(ivec2 texel) {
  ivec2 last = textureSize(gbuffer_depth, 0) - 1;
  uint here = object_at(texel);
  bool edge = here != object_at(min(texel + ivec2(1, 0), last)) || here != object_at(min(texel + ivec2(0, 1), last));
  return vec3(edge ? 1.0 : 0.0);
}

vec4 shown(ivec2 texel) { return vec4(mix(empty_colour, vec3(1.0), value(texel)), 1.0); }

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
