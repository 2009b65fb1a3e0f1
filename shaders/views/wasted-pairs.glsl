// The colour of the number of shaded pairs out of range.
vec4 shown(ivec2 texel) {
  vec4 pairs = texelFetch(counts, texel, 0);
  int colour = 0;
  for (int i = 1; i < 6; ++i) colour += int(pairs.g - pairs.b) >= wasted_from[i] ? 1 : 0;
  return on_surfaces(texel, count_palette[colour]);
}

vec4 raw(ivec2 texel) {
  vec4 pairs = texelFetch(counts, texel, 0);
  return vec4(vec3(pairs.g - pairs.b) / 255.0, 1.0);
}
