// By the same choice as the lighting, before a point is moved by the biases.
#include "picked_shadow.glsl"

vec3 value(ivec2 texel) {
  int map = map_of_picked(read_surface(texel));
#if SHADOWS
  if (map >= 0) map -= read_light(picked_light).shadow_map;
#endif
  return vec3(float(map));
}

vec4 shown(ivec2 texel) {
  int map = int(value(texel).x);
  return on_surfaces(texel, map < 0 ? empty_colour : colour_of_class(map));
}

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
