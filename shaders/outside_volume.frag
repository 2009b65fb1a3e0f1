// Only what the method draws of it: faces that it culls, seen from the camera, and what its planes cut are left out. AS_WIRE
// draws all of it, faintly.
#include "shared.h"

in vec3 relative;
flat in vec3 colour, centre;
uniform ivec2 kept_faces;  // front, back: 1 where they are drawn
uniform int cut;           // 1: near and far plane cut the mesh
layout(location = 0) out vec4 picture;

void main() {
#if AS_WIRE
  picture = vec4(colour, 0.35);
#else
  vec3 normal = normalize(cross(dFdx(relative), dFdy(relative)));
  if (dot(normal, relative - centre) < 0.0) normal = -normal;  // outwards: the mesh is convex
  vec3 from_camera = ray_forward.w > 0.5 ? ray_forward.xyz : relative;
  bool front = dot(normal, from_camera) < 0.0;
  if ((front ? kept_faces.x : kept_faces.y) == 0) discard;
  float range = dot(relative, ray_forward.xyz);
  if (cut == 1 && (range < planes.x || range > planes.y)) discard;
  picture = vec4(colour * (0.55 + 0.45 * abs(normal.y)), front ? 0.45 : 0.3);
#endif
}
