// As the display shows it.
vec3 value(ivec2 texel) { return display(texelFetch(lit, texel, 0).rgb, shading.w); }

vec4 shown(ivec2 texel) { return vec4(value(texel), 1.0); }

vec4 raw(ivec2 texel) { return raw_lit(texel); }
