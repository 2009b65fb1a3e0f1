// pairs_lit: for every surface point the lights whose range reaches it, by brute force.
#include "gbuffer_read.glsl"
#include "lights.glsl"

layout(location = 0) out vec4 count;

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  float lit = 0.0;
  for (int i = 0; s.present && i < lights.x; ++i) {
    if (reaches(read_light(i), s.position)) lit += 1.0;
  }
  count = vec4(lit, 0.0, 0.0, 0.0);
}
