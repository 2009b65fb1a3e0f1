// Where no surface is.
#include "shared.h"

vec3 background_radiance(vec2 ndc) {
#if SKY
  // A clear day, from horizon to zenith; below the horizon the ground's haze. All rays of an orthographic camera are
  // parallel.
  vec3 direction = normalize(ray_forward.xyz + (1.0 - ray_forward.w) * (ndc.x * ray_right.xyz + ndc.y * ray_up.xyz));
  float height = direction.y;
  if (height < 0.0) return mix(vec3(0.42, 0.45, 0.47), vec3(0.16, 0.15, 0.14), min(-4.0 * height, 1.0));
  return mix(vec3(0.62, 0.74, 0.86), vec3(0.10, 0.24, 0.55), pow(height, 0.6));
#else
  return background.rgb;
#endif
}
