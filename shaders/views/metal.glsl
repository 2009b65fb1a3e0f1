// Dark where the surface is no metal.
vec3 value(ivec2 texel) { return vec3(read_surface(texel).metal); }

vec4 shown(ivec2 texel) { return on_surfaces(texel, clamp(value(texel), 0.0, 1.0)); }

vec4 raw(ivec2 texel) { return raw_reflectance(texel); }
