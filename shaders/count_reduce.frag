// Sums of COUNT_BLOCK x COUNT_BLOCK pixels: small enough to be exact in float, few enough to read back.
#include "shared.h"

uniform sampler2D counts;
uniform sampler2D counts_lit;
layout(location = 0) out vec4 sums;

void main() {
  ivec2 size = textureSize(counts, 0);
  ivec2 first = ivec2(gl_FragCoord.xy) * COUNT_BLOCK;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < COUNT_BLOCK; ++y)
    for (int x = 0; x < COUNT_BLOCK; ++x) {
      ivec2 texel = first + ivec2(x, y);
      if (texel.x < size.x && texel.y < size.y)
        sum += vec4(texelFetch(counts, texel, 0).rgb, texelFetch(counts_lit, texel, 0).r);
    }
  sums = sum;
}
