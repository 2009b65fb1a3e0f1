// A light's volume, or the whole screen for a light without end. INSTANCED: all lights of one shape in one draw.
#include "light_proxy.glsl"
#include "varyings.glsl"

layout(location = 0) in vec3 vertex;  // of the unit mesh
#if INSTANCED
uniform int kept_lights;       // KEEP_ALL, or those that the camera is inside or outside of
uniform bool inside_the_mesh;  // inside = nearer than the mesh reaches (else: than the light) …
uniform float inside_margin;   // … plus this
#else
uniform int light_index;
#endif
flat out int light;
invariant gl_Position;  // the stencil method draws a volume twice, by two programs

#if INSTANCED
bool kept(Light l) {
  if (int(light_trait(light, 0).y) != SHAPE) return false;
  if (kept_lights == KEEP_ALL) return true;
  float reach = inside_the_mesh ? proxy_reach(l) : l.range;
  return (length(l.position) < reach + inside_margin) == (kept_lights == KEEP_INSIDE);
}
#endif

vec4 volume_position(Light l) {
#if SHAPE == VOLUME_SCREEN
  return vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);  // as fullscreen.vert
#else
  vec4 position = clip_from_relative * vec4(proxy_vertex(l, vertex), 1.0);
#if !TRUE_DEPTH
  position.z = 0.5 * position.w;  // where neither plane cuts, be depth -1 … 1 or 0 … 1
#endif
  return position;
#endif
}

void main() {
  pass_varyings();
#if INSTANCED
  light = gl_InstanceID;
  Light l = read_light(light);
  gl_Position = kept(l) ? volume_position(l) : vec4(2.0, 2.0, 0.0, 1.0);  // all vertices at one point: no pixel
#else
  light = light_index;
  gl_Position = volume_position(read_light(light));
#endif
}
