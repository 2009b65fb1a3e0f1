// One pixel here is a block of BLOCK x BLOCK pixels: how near and how far the surfaces are that lights may reach.
#include "gbuffer_read.glsl"

layout(location = 0) out vec4 depths;  // two DepthSpan of renderer/light/cluster_grid.h

uniform float end_of_reach;  // along the view axis: farther surfaces do not count

float read_range(ivec2 texel) {
#if !defined(STORED_POSITION) && POSITION_RECONSTRUCT == RECONSTRUCT_VIEW_RAY
  return range_from_depth(read_depth(texel));
#else
  return dot(read_position(texel), ray_forward.xyz);
#endif
}

const float kSameSurface = 1.08;  // factor between depths: about a slice

vec2 with(vec2 span, float range, bool wanted) {
  return wanted ? vec2(min(span.x, range), max(span.y, range)) : span;
}

// Two spans, so that what lies between the surfaces at an edge does not count: one is grown by all that is near to it,
// the other takes the rest.
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * BLOCK, end = min(first + BLOCK, ivec2(viewport.xy));
  const vec2 none = vec2(uintBitsToFloat(0x7f800000u), 0.0);
  depths = vec4(none, none);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      ivec2 texel = ivec2(x, y);
      float range = max(read_range(texel), planes.x);
      bool wanted = range <= end_of_reach && read_present(texel);
      bool near_first = depths.y == 0.0 || (range * kSameSurface >= depths.x && range <= depths.y * kSameSurface);
      depths.xy = with(depths.xy, range, wanted && near_first);
      depths.zw = with(depths.zw, range, wanted && !near_first);
    }
}
