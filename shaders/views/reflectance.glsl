// sRGB-coded, as pictures are.
vec3 value(ivec2 texel) { return read_surface(texel).f0; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, coded_from_linear(value(texel))); }

vec4 raw(ivec2 texel) { return raw_reflectance(texel); }
