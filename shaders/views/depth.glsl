// Distance along the view axis, from dark to light.
vec3 value(ivec2 texel) { return vec3(range_from_depth(read_depth(texel))); }

vec4 shown(ivec2 texel) { return on_surfaces(texel, clamp(of_range(value(texel)), 0.0, 1.0)); }

vec4 raw(ivec2 texel) { return vec4(vec3(read_depth(texel)), 1.0); }
