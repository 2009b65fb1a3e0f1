// The first pixels of a tile, or of a cluster's column or row.
ivec2 cell_of(ivec2 texel) { return ivec2(floor((vec2(texel) + 0.5) * cells_per_pixel)); }

vec3 value(ivec2 texel) {
  ivec2 here = cell_of(texel);
  bool first = here.x != cell_of(texel - ivec2(1, 0)).x || here.y != cell_of(texel - ivec2(0, 1)).y;
  return vec3(first ? 1.0 : 0.0);
}

vec4 shown(ivec2 texel) { return vec4(mix(empty_colour, vec3(1.0), value(texel)), 1.0); }

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
