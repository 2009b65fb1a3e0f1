// The wire of a light's volume over a view.
#include "light_proxy.glsl"
#include "varyings.glsl"

layout(location = 0) in vec3 vertex;
uniform int light_index;
out vec3 relative;
flat out vec3 colour;

void main() {
  pass_varyings();
  Light l = read_light(light_index);
  relative = proxy_vertex(l, vertex);
  colour = l.colour;
  gl_Position = clip_from_relative * vec4(relative, 1.0);
}
