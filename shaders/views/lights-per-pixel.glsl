// The colour of the number of shaded pairs in range.
vec4 shown(ivec2 texel) { return on_surfaces(texel, count_palette[int(min(texelFetch(counts, texel, 0).b, 5.0))]); }

vec4 raw(ivec2 texel) { return vec4(texelFetch(counts, texel, 0).bbb / 255.0, 1.0); }
