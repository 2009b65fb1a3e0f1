// The colour of the number of fragments that were written here.
vec3 value(ivec2 texel) { return texelFetch(redrawn_counts, texel, 0).rrr; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, colour_of_count(value(texel).x)); }

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
