// A unit sphere mesh, scaled and moved to one light.
#include "lights.glsl"
#include "varyings.glsl"

layout(location = 0) in vec3 vertex;  // on the unit sphere
uniform int light_index;
uniform float volume_scale;           // of the mesh: 1 inscribed, 1/inradius circumscribed
flat out int light;

void main() {
  light = light_index;
  pass_varyings();
#if WHOLE_SCREEN
  // A light without end has no volume: the triangle of fullscreen.vert.
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
#else
  Light l = read_light(light_index);
  gl_Position = clip_from_relative * vec4(l.position + vertex * (l.range * volume_scale), 1.0);
#if !CLIP_PLANES
  gl_Position.z = 0.0;  // mid-depth: neither the near nor the far plane cuts the volume
#endif
#endif
}
