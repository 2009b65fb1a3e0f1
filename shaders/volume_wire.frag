// Parts behind a surface are faint; nothing is hidden, nothing of the picture below is changed but these lines.
#include "position.glsl"

uniform sampler2D gbuffer_depth;
in vec3 relative;
flat in vec3 colour;
layout(location = 0) out vec4 line;

void main() {
  float depth = texelFetch(gbuffer_depth, ivec2(gl_FragCoord.xy), 0).r;
  bool hidden = depth != kFarDepth && dot(relative, ray_forward.xyz) > range_from_depth(depth);
  line = vec4(colour / max(max(colour.r, colour.g), colour.b), hidden ? 0.25 : 0.8);
}
