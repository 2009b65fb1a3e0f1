// A line around the picked object, outside it: no pixel of the object is covered.
uniform usampler2D ids;
uniform int picked;
layout(location = 0) out vec4 line;

bool on_object(ivec2 texel) {
  return int(texelFetch(ids, clamp(texel, ivec2(0), textureSize(ids, 0) - 1), 0).r) == picked;
}

void main() {
  const int kWidth = 2;  // pixels
  ivec2 here = ivec2(gl_FragCoord.xy);
  if (on_object(here)) discard;
  bool beside = false;
  for (int y = -kWidth; y <= kWidth; ++y)
    for (int x = -kWidth; x <= kWidth; ++x) beside = beside || on_object(here + ivec2(x, y));
  if (!beside) discard;
  line = vec4(1.0, 0.75, 0.1, 1.0);
}
