// What the depth buffer holds, as a distance along the view axis, and back.
#include "shared.h"

#if DEPTH_REVERSED
const float kFarDepth = 0.0;
float depth_from_far(float depth) { return depth; }
float ndc_of_depth(float depth) { return depth; }
#else
const float kFarDepth = 1.0;
float depth_from_far(float depth) { return 1.0 - depth; }
float ndc_of_depth(float depth) { return depth * 2.0 - 1.0; }
#endif

// Distance along the view axis, world units.
float range_from_depth(float depth) {
  if (ray_forward.w > 0.5) return planes.y - depth_from_far(depth) * planes.w;  // orthographic
  // near far / (far - depth (far - near)), without its cancellation: 1 - depth is exact from 0.5 on. Near 1, far
  // 10000 at 9000 units: the other form is off by 5 units in float, this one by 0.001.
  return planes.z / (planes.x + depth_from_far(depth) * planes.w);
}

// The other way.
float depth_from_range(float range) {
  float from_far = ray_forward.w > 0.5 ? (planes.y - range) / planes.w : (planes.z / range - planes.x) / planes.w;
  return depth_from_far(from_far);  // its own inverse
}
