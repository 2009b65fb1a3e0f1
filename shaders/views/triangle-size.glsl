// The area of the seen triangle on screen; a colour for each factor of four.
vec3 value(ivec2 texel) { return texelFetch(redrawn_triangles, texel, 0).rrr; }

vec4 shown(ivec2 texel) {
  float area = value(texel).x;
  int smaller = 0;
  for (float bound = 256.0; bound >= 1.0; bound /= 4.0) smaller += area < bound ? 1 : 0;
  return on_surfaces(texel, colour_of_class(smaller));
}

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
