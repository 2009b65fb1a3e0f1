// What the lighting makes of the G-buffer's normal and position, as floats for the measures.
#include "gbuffer_read.glsl"

layout(location = 0) out vec4 normal;
layout(location = 1) out vec4 position;

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  normal = vec4(s.normal, 1.0);
  position = vec4(s.position, 1.0);
}
