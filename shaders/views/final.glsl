// As the display shows it.
vec4 shown(ivec2 texel) { return vec4(display(texelFetch(lit, texel, 0).rgb, shading.w), 1.0); }

vec4 raw(ivec2 texel) { return raw_lit(texel); }
