// Radiance cut to what a picture can hold.
vec4 shown(ivec2 texel) { return vec4(clamp(texelFetch(lit, texel, 0).rgb, 0.0, 1.0), 1.0); }

vec4 raw(ivec2 texel) { return raw_lit(texel); }
