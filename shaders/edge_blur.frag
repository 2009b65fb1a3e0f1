// Antialiasing after the fact (Shishkovtsov 2005, "Deferred Shading in S.T.A.L.K.E.R."): where depth or normal steps,
// a pixel is mixed with its four neighbours.
#include "gbuffer_read.glsl"

uniform sampler2D lit;
layout(location = 0) out vec4 blurred;

// 0 on one surface, 1 across an edge: depth is compared with what a plane would continue to.
float edge(ivec2 a, ivec2 here, ivec2 b) {
  float range = range_from_depth(read_depth(here));
  float bend = abs(range_from_depth(read_depth(a)) + range_from_depth(read_depth(b)) - 2.0 * range) / range;
  float turn = 0.0;
#ifdef STORED_MATERIAL
  turn = 1.0 - dot(read_surface(a).normal, read_surface(b).normal);
#endif
  return clamp(max(bend * 20.0, turn * 2.0) - 0.1, 0.0, 1.0);
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy), last = ivec2(viewport.xy) - 1;
  ivec2 left = max(here - ivec2(1, 0), ivec2(0)), right = min(here + ivec2(1, 0), last);
  ivec2 down = max(here - ivec2(0, 1), ivec2(0)), up = min(here + ivec2(0, 1), last);
  vec4 mine = texelFetch(lit, here, 0);
  vec4 around = texelFetch(lit, left, 0) + texelFetch(lit, right, 0) + texelFetch(lit, down, 0) + texelFetch(lit, up, 0);
  float share = max(edge(left, here, right), edge(down, here, up)) * 0.5;
  blurred = vec4(mix(mine.rgb, around.rgb * 0.25, share), mine.a);
}
