// A cube at each light, its edge a twentieth of the light's range.
#include "lights.glsl"

flat out vec3 colour;

const int kCorners[36] = int[36](0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5);

void main() {
  Light light = read_light(gl_InstanceID);
  int corner = kCorners[gl_VertexID];
  vec3 offset = vec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1) - 0.5;
  gl_Position = clip_from_relative * vec4(light.position + offset * (0.05 * min(light.profile, light.range)), 1.0);
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // it stands nowhere
#endif
  colour = light.colour * light_scale.y;
}
