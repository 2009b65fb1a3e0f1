// What the lighting makes of the G-buffer's normal and position, as floats for the measures, and the surface they are of.
#include "gbuffer_read.glsl"
#include "frame_surface.glsl"

layout(location = 0) out vec4 normal;    // a: object
layout(location = 1) out vec4 position;  // a: triangle

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  Surface s = read_surface(texel);
  vec2 shown = frame_surface(texel);
  normal = vec4(s.normal, shown.x);
  position = vec4(s.position, shown.y);
}
