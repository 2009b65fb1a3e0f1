// Two triangles per light: the bounds of its sphere on screen, which the CPU has found (renderer/light/light_bounds.h).
#include "lights.glsl"
#include "varyings.glsl"

flat out int light;

void main() {
  pass_varyings();
  light = gl_InstanceID;
  vec4 bounds = table_at(light_data, (lights.x + DARK_LIGHTS) * LIGHT_TEXELS + light);
  int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;  // 0 1 2, 3 2 1
  gl_Position = vec4(mix(bounds.xy, bounds.zw, vec2(corner & 1, corner >> 1)), 0.0, 1.0);
}
