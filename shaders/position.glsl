// From a pixel and its stored depth to the surface point. One function per position.reconstruct.
#include "shared.h"

// Distance along the view axis, world units.
float range_from_depth(float depth) {
  if (ray_forward.w > 0.5) return planes.x + depth * planes.w;  // orthographic
  // near far / (far - depth (far - near)), without its cancellation: 1 - depth is exact from 0.5 on. Near 1, far
  // 10000 at 9000 units: the other form is off by 5 units in float, this one by 0.001.
  return planes.z / (planes.x + (1.0 - depth) * planes.w);
}

vec2 ndc_of_pixel(vec2 frag_coord) { return frag_coord * viewport.zw * 2.0 - 1.0; }

// Relative to the camera, world axes.
vec3 position_by_view_ray(vec2 ndc, float depth) {
  float range = range_from_depth(depth);
  vec3 sideways = ndc.x * ray_right.xyz + ndc.y * ray_up.xyz;
  if (ray_forward.w > 0.5) return range * ray_forward.xyz + sideways;
  return range * (ray_forward.xyz + sideways);
}

// Through the float inverse of the float view-projection, as source 0 (pointlightfragment.glsl lines 23-24).
vec3 position_by_inverse_viewproj(vec2 ndc, float depth) {
  vec4 world = world_from_clip * vec4(ndc, depth * 2.0 - 1.0, 1.0);
  return world.xyz / world.w - camera_position.xyz;
}

vec3 position_of(vec2 ndc, float depth) {
#if POSITION_RECONSTRUCT == RECONSTRUCT_VIEW_RAY
  return position_by_view_ray(ndc, depth);
#else
  return position_by_inverse_viewproj(ndc, depth);
#endif
}
