// Objects, one instance record each: into the G-buffer, or forward.
#include "shared.h"

layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 normal_object;
layout(location = 2) in vec4 tangent_object;
layout(location = 3) in vec2 uv0_in;
layout(location = 4) in vec2 uv1_in;
layout(location = 5) in vec4 colour_in;

uniform number_table instance_data;
uniform int first_instance;
#if SHADOW_MAP
uniform mat4 shadow_clip_from_anchored;  // of the light's map; `relative` is then relative to the maps' anchor
#endif

out vec3 relative;  // position, from the camera
out vec3 normal;
out vec3 tangent;
out vec3 bitangent;
out vec2 uv0;
out vec2 uv1;
out vec4 colour;
flat out uint object_id;
flat out mat3 object_axes;
#if TRIANGLE_IDS
flat out uint triangle;  // of the mesh, from 0: its corners are drawn without sharing, in parts
uniform int first_triangle;
out vec3 corner_by_w;  // barycentric coordinates of the second and the third corner, and 1, times w: then their ratios are
                       // even on screen
#endif
// Passes of other programs test for this very depth.
invariant gl_Position;
#if CLIP_PLANE && !SHADOW_MAP && HAS_CLIP_DISTANCE
uniform vec4 clip_plane;  // relative to the camera: what is behind it is cut away
out float gl_ClipDistance[1];
#endif

vec4 instance_texel(int k) {
  return table_at(instance_data, (first_instance + gl_InstanceID) * INSTANCE_TEXELS + k);
}

void main() {
  // Made in double relative to the camera and rounded once on the CPU.
  mat4 clip_from_object = mat4(instance_texel(0), instance_texel(1), instance_texel(2), instance_texel(3));
  mat3x4 relative_rows = mat3x4(instance_texel(4), instance_texel(5), instance_texel(6));
  mat3 normals = mat3(instance_texel(7).xyz, instance_texel(8).xyz, instance_texel(9).xyz);
  gl_Position = clip_from_object * vec4(vertex, 1.0);
  relative = vec4(vertex, 1.0) * relative_rows;
#if SHADOW_MAP
  gl_Position = shadow_clip_from_anchored * vec4(relative, 1.0);
#endif
#if CLIP_PLANE && !SHADOW_MAP && HAS_CLIP_DISTANCE
  gl_ClipDistance[0] = dot(clip_plane, vec4(relative, 1.0));
#endif
#if MISTAKE_NONUNIFORM_SCALE_NORMAL
  normal = vec4(normal_object, 0.0) * relative_rows;
#else
  normal = normals * normal_object;
#endif
  tangent = vec4(tangent_object.xyz, 0.0) * relative_rows;
  bitangent = tangent_object.w * cross(normal, tangent) * instance_texel(7).w;  // w: -1 where the object is mirrored
  uv0 = uv0_in;
  uv1 = uv1_in;
  colour = colour_in;
  object_id = uint(instance_texel(8).w);
  object_axes = normals;
#if TRIANGLE_IDS
  triangle = uint(first_triangle + gl_VertexID / 3);
  corner_by_w = vec3(gl_VertexID % 3 == 1, gl_VertexID % 3 == 2, 1.0) * gl_Position.w;
#endif
}
