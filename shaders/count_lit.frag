// pairs_lit: for every surface point the lights whose range reaches it, by brute force.
#include "gbuffer_read.glsl"
#include "lights.glsl"

layout(location = 0) out vec4 count;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 position = read_position(texel);
  float lit = 0.0;
  for (int i = 0; read_depth(texel) != kFarDepth && i < lights.x; ++i) {
    if (reaches(read_light(i), position)) lit += 1.0;
  }
  count = vec4(lit, 0.0, 0.0, 0.0);
}
