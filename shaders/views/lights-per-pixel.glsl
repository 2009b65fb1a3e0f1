// The colour of the number of shaded pairs in range.
vec3 value(ivec2 texel) { return texelFetch(counts, texel, 0).bbb; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, colour_of_count(value(texel).x)); }

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
