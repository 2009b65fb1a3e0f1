// The wire of a light's volume over a view.
#include "lights.glsl"
#include "varyings.glsl"

layout(location = 0) in vec3 vertex;
uniform int light_index;
uniform float volume_scale;
out vec3 relative;
flat out vec3 colour;

void main() {
  pass_varyings();
  Light l = read_light(light_index);
  relative = l.position + vertex * (l.range * volume_scale);
  colour = l.colour;
  gl_Position = clip_from_relative * vec4(relative, 1.0);
}
