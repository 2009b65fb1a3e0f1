// Pairs shaded in range, less those that reach the surface.
vec3 value(ivec2 texel) { return vec3(texelFetch(counts, texel, 0).b - texelFetch(counts_lit, texel, 0).r); }

vec4 shown(ivec2 texel) {
  float too_many = value(texel).x;
  return on_surfaces(texel, colour_of_class(too_many < -0.5 ? 1 : too_many > 0.5 ? 2 : 0));
}

vec4 raw(ivec2 texel) { return vec4(abs(value(texel)) / 255.0, 1.0); }
