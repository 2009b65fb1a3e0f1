// The colour of the number of shaded pairs out of range.
vec3 value(ivec2 texel) {
  vec4 pairs = texelFetch(counts, texel, 0);
  return vec3(pairs.g - pairs.b);
}

vec4 shown(ivec2 texel) { return on_surfaces(texel, colour_of_count(value(texel).x)); }

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
