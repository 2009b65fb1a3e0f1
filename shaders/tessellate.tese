// A corner of the pieces: between the patch's corners, then down along the normal by the height map. To the same bit from both
// patches of an edge: of a coordinate that is 0 the product is 0, and sums of two do not depend on their order.
layout(triangles, equal_spacing, ccw) in;

in vec3 patch_position[];
in vec3 patch_normal[];
in vec4 patch_tangent[];
in vec2 patch_uv0[];
in vec2 patch_uv1[];
in vec4 patch_colour[];
out vec3 captured_position;
out vec3 captured_normal;
out vec4 captured_tangent;
out vec2 captured_uv0;
out vec2 captured_uv1;
out vec4 captured_colour;

uniform sampler2D height_map;      // red: 1 the flat surface, 0 the lowest place
uniform float height_depth;        // world units between them
uniform mat3 normals;              // world from object
uniform mat3 object_from_world;

void main() {
  vec3 w = gl_TessCoord;
  precise vec3 place = w.x * patch_position[0] + w.y * patch_position[1] + w.z * patch_position[2];
  precise vec3 normal = w.x * patch_normal[0] + w.y * patch_normal[1] + w.z * patch_normal[2];
  precise vec2 uv = w.x * patch_uv0[0] + w.y * patch_uv0[1] + w.z * patch_uv0[2];
  precise float depth = height_depth * (1.0 - textureLod(height_map, uv, 0.0).r);
  precise vec3 down = object_from_world * (normalize(normals * normal) * depth);
  precise vec3 moved = place - down;
  captured_position = moved;
  captured_normal = normalize(normal);
  captured_tangent = w.x * patch_tangent[0] + w.y * patch_tangent[1] + w.z * patch_tangent[2];
  captured_uv0 = uv;
  captured_uv1 = w.x * patch_uv1[0] + w.y * patch_uv1[1] + w.z * patch_uv1[2];
  captured_colour = w.x * patch_colour[0] + w.y * patch_colour[1] + w.z * patch_colour[2];
  gl_Position = vec4(0.0);
}
