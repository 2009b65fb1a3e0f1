// A texel of the picked light's map as wide as it is where the surface is, in pixels.
#include "picked_shadow.glsl"

vec3 value(ivec2 texel) {
  Surface s = read_surface(texel);
  int map = map_of_picked(s);
  if (map < 0) return vec3(-1.0);
#if SHADOWS
  float width = shadow_record(map * SHADOW_MAP_TEXELS + 4).z * (shadow_matrix(map) * vec4(s.position, 1.0)).w;
  float away = ray_forward.w > 0.5 ? 1.0 : dot(s.position, ray_forward.xyz);
  return vec3(width / (away * 2.0 * length(ray_up.xyz) * viewport.w));
#else
  return vec3(-1.0);
#endif
}

vec4 shown(ivec2 texel) {
  float pixels = value(texel).x;
  if (pixels < 0.0) return on_surfaces(texel, empty_colour);
  return on_surfaces(texel, colour_of_class(int(pixels >= 0.25) + int(pixels >= 1.0) + int(pixels >= 2.0) + int(pixels >= 4.0) +
                                            int(pixels >= 16.0)));
}

vec4 raw(ivec2 texel) { return vec4(value(texel) / 16.0, 1.0); }
