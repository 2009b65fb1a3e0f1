// A patch's corner, as it is.
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 normal_object;
layout(location = 2) in vec4 tangent_object;
layout(location = 3) in vec2 uv0_in;
layout(location = 4) in vec2 uv1_in;
layout(location = 5) in vec4 colour_in;

out vec3 corner_position;
out vec3 corner_normal;
out vec4 corner_tangent;
out vec2 corner_uv0;
out vec2 corner_uv1;
out vec4 corner_colour;

void main() {
  corner_position = vertex;
  corner_normal = normal_object;
  corner_tangent = tangent_object;
  corner_uv0 = uv0_in;
  corner_uv1 = uv1_in;
  corner_colour = colour_in;
}
