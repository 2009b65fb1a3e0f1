// Radiance cut to what a picture can hold.
vec3 value(ivec2 texel) { return texelFetch(lit, texel, 0).rgb; }

vec4 shown(ivec2 texel) { return vec4(clamp(value(texel), 0.0, 1.0), 1.0); }

vec4 raw(ivec2 texel) { return raw_lit(texel); }
