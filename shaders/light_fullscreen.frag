// Every pixel loops over every light; with RADIUS_TEST it shades only those in range.
#include "light_loop.glsl"

void take(Receiver r, Light some, inout Sums sums) {
#if RADIUS_TEST
  test_and_add(r, some, sums);
#else
  sums.counts.x += 1.0;
  add_light(r, some, sums);
#endif
}

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) {
    write_background();
    return;
  }
  Receiver r = receiver_of(s);
  Sums sums = no_sums();
#if LIGHTS_AT_ONCE == 4
  ivec2 fours = light_fours();
  for (int i = 0; i < fours.x; ++i) take(r, read_plain_four(i), sums);
#if MIXED_LIGHTS
  for (int i = fours.x; i < fours.y; ++i) take(r, read_four(i), sums);
#endif
#else
  for (int i = 0; i < lights.x; ++i) take(r, read_light(i), sums);
#endif
  write_sums(s, r, sums);
}
