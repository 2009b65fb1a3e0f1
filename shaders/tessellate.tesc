// Into how many pieces each edge of a triangle is cut. An edge's own ends decide, in whatever order they come: then both patches
// that share it cut it alike.
layout(vertices = 3) out;

in vec3 corner_position[];
in vec3 corner_normal[];
in vec4 corner_tangent[];
in vec2 corner_uv0[];
in vec2 corner_uv1[];
in vec4 corner_colour[];
out vec3 patch_position[];
out vec3 patch_normal[];
out vec4 patch_tangent[];
out vec2 patch_uv0[];
out vec2 patch_uv1[];
out vec4 patch_colour[];

uniform float level;
uniform mat4 relative_from_object;
uniform float picture_height;  // of an orthographic camera, world units; 0: a perspective one

float level_of(vec3 a, vec3 b, vec3 seen_at) {
#if BY_DISTANCE
  float away = picture_height > 0.0 ? picture_height : length((relative_from_object * vec4(seen_at, 1.0)).xyz);
  float wide = length(mat3(relative_from_object) * (a - b));
  return clamp(ceil(level * wide / max(away, 1e-6)), 1.0, level);
#else
  return level;
#endif
}

void main() {
  patch_position[gl_InvocationID] = corner_position[gl_InvocationID];
  patch_normal[gl_InvocationID] = corner_normal[gl_InvocationID];
  patch_tangent[gl_InvocationID] = corner_tangent[gl_InvocationID];
  patch_uv0[gl_InvocationID] = corner_uv0[gl_InvocationID];
  patch_uv1[gl_InvocationID] = corner_uv1[gl_InvocationID];
  patch_colour[gl_InvocationID] = corner_colour[gl_InvocationID];
  if (gl_InvocationID != 0) return;
  vec3 p[3] = vec3[3](corner_position[0], corner_position[1], corner_position[2]);
  float most = 1.0;
  for (int i = 0; i < 3; ++i) {
    vec3 a = p[(i + 1) % 3], b = p[(i + 2) % 3];
#if MISTAKE_TESSELLATION_UNEQUAL_EDGES
    gl_TessLevelOuter[i] = level_of(p[0], p[1], (p[0] + p[1] + p[2]) / 3.0);
#else
    gl_TessLevelOuter[i] = level_of(a, b, 0.5 * (a + b));
#endif
    most = max(most, gl_TessLevelOuter[i]);
  }
  gl_TessLevelInner[0] = most;
}
