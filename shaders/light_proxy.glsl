// The mesh that stands for a light, moved to it: by SHAPE a sphere, or a cone for a narrow spot.
#include "lights.glsl"
#include "volume_mesh.glsl"

uniform float volume_scale;  // see volume_mesh.glsl
uniform float depth_step;    // difference of window depth that rounding can hide; 0: depths are not compared

// A proxy contains its volume, to the depth test too: what such a step is worth at the volume's far side, in world
// units. (Window depth is far / (far - near) (1 - near / range), so a step is worth more the farther away.)
float depth_slack(Light l) {
  if (ray_forward.w > 0.5) return depth_step * planes.w;
  float range = clamp(dot(l.position, ray_forward.xyz) + l.range, planes.x, planes.y);
  return depth_step * range * range * planes.w / planes.z;
}

#if SHAPE == VOLUME_CONE
vec3 proxy_vertex(Light l, vec3 vertex) {
  return l.position + cone_vertex(vertex, l.direction, l.range, l.outer_cos, volume_scale, depth_slack(l));
}
float proxy_reach(Light l) { return cone_reach(l.range, l.outer_cos, volume_scale, depth_slack(l)); }
#else
vec3 proxy_vertex(Light l, vec3 vertex) {
  return l.position + sphere_vertex(vertex, l.range, volume_scale, depth_slack(l));
}
float proxy_reach(Light l) { return sphere_reach(l.range, volume_scale, depth_slack(l)); }
#endif
