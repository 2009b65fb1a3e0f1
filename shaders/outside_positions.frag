// Where the lighting takes each pixel's surface to be, from the camera; a = 1 where there is one.
#include "gbuffer_read.glsl"

layout(location = 0) out vec4 position;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  position = vec4(read_position(texel), read_depth(texel) != kFarDepth ? 1.0 : 0.0);
}
