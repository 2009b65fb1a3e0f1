// The colour of the number of faces turned away: culled ones in front of what is seen, and what is seen itself.
vec3 value(ivec2 texel) {
  return vec3(texelFetch(redrawn_counts, texel, 0).g + texelFetch(redrawn_triangles, texel, 0).b);
}

vec4 shown(ivec2 texel) { return on_surfaces(texel, colour_of_count(value(texel).x)); }

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
