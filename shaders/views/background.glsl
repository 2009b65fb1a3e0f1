// Where the depth is as it was cleared.
vec3 value(ivec2 texel) { return vec3(read_depth(texel) == kFarDepth ? 1.0 : 0.0); }

vec4 shown(ivec2 texel) { return vec4(mix(vec3(0.0), empty_colour, value(texel)), 1.0); }

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
