// The surface point: how it is stored, and how it comes back. One function per position.source and
// position.reconstruct. Positions are relative to the camera, along the world's axes.
#include "depth.glsl"

// ---- from depth --------------------------------------------------------------------------------------------
vec2 ndc_of_pixel(vec2 frag_coord) { return frag_coord * viewport.zw * 2.0 - 1.0; }

vec3 position_by_view_ray(vec2 ndc, float range) {
  vec3 sideways = ndc.x * ray_right.xyz + ndc.y * ray_up.xyz;
  if (ray_forward.w > 0.5) return range * ray_forward.xyz + sideways;
  return range * (ray_forward.xyz + sideways);
}

// Through the float inverse of the float view-projection, as source 0 (pointlightfragment.glsl lines 23-24).
vec3 position_by_inverse_viewproj(mat4 inverse_viewproj, vec2 ndc, float depth) {
  vec4 world = inverse_viewproj * vec4(ndc, ndc_of_depth(depth), 1.0);
  return world.xyz / world.w - camera_position.xyz;
}

#if VARYING_INVERSE && !defined(COMPUTE)
in mat4 inverse_viewproj;  // source 0 takes the inverse in its vertex shader (pointlightvertex.glsl)
#define INVERSE_VIEWPROJ inverse_viewproj
#else
#define INVERSE_VIEWPROJ world_from_clip
#endif

vec3 position_from_depth(vec2 ndc, float depth) {
#if POSITION_RECONSTRUCT == RECONSTRUCT_VIEW_RAY
  return position_by_view_ray(ndc, range_from_depth(depth));
#else
  return position_by_inverse_viewproj(INVERSE_VIEWPROJ, ndc, depth);
#endif
}

// ---- from an attachment ------------------------------------------------------------------------------------
const float kViewScale = 1.0e6;  // source 4's posScale

vec3 to_view(vec3 relative) { return mat3(view_from_world) * relative; }
vec3 from_view(vec3 view) { return view * mat3(view_from_world); }  // a rotation's inverse is its transpose

vec4 pack_position(vec3 relative) {
#if POSITION_SOURCE == POSITION_LINEAR32F
  return vec4(dot(relative, ray_forward.xyz), 0.0, 0.0, 0.0);
#elif POSITION_SOURCE == POSITION_WORLD16F || POSITION_SOURCE == POSITION_WORLD32F
  return vec4(relative + camera_position.xyz, 1.0);
#elif POSITION_SOURCE == POSITION_VIEW_SCALED
  return vec4(to_view(relative) / kViewScale + 0.5, 1.0);
#else
  return vec4(to_view(relative), 1.0);
#endif
}

vec3 unpack_position(vec4 stored, vec2 ndc) {
#if POSITION_SOURCE == POSITION_LINEAR32F
  return position_by_view_ray(ndc, stored.x);
#elif POSITION_SOURCE == POSITION_WORLD16F || POSITION_SOURCE == POSITION_WORLD32F
  return stored.xyz - camera_position.xyz;
#elif POSITION_SOURCE == POSITION_VIEW_SCALED
  return from_view((stored.xyz - 0.5) * kViewScale);
#else
  return from_view(stored.xyz);
#endif
}
