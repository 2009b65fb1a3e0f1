// Objects into the G-buffer.
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 normal_object;
layout(location = 2) in vec4 tangent_object;
layout(location = 3) in vec2 uv_in;

uniform mat4 clip_from_object;        // made in double, rounded once
uniform mat3 world_from_object;       // directions
uniform mat3 world_from_object_normal;  // inverse transpose: normals under non-uniform scale

out vec3 normal;
out vec3 tangent;
out vec3 bitangent;
out vec2 uv;

void main() {
  gl_Position = clip_from_object * vec4(vertex, 1.0);
  normal = world_from_object_normal * normal_object;
  tangent = world_from_object * tangent_object.xyz;
  bitangent = tangent_object.w * cross(normal, tangent);
  uv = uv_in;
}
