// The mesh that stands for the picked light, seen from outside.
#include "light_proxy.glsl"

layout(location = 0) in vec3 vertex;
uniform int light_index;
uniform mat4 outside_clip;
out vec3 relative;
flat out vec3 colour, centre;

void main() {
  Light l = read_light(light_index);
  relative = proxy_vertex(l, vertex);
  colour = l.colour / max(max(l.colour.r, l.colour.g), max(l.colour.b, 1.0e-6));
  centre = l.position;
  gl_Position = outside_clip * vec4(relative, 1.0);
}
