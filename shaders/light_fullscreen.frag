// Every pixel loops over every light; with RADIUS_TEST it shades only those in range.
#include "light_loop.glsl"

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) {
    write_background();
    return;
  }
  Receiver r = receiver_of(s);
  Sums sums = no_sums();
  for (int i = 0; i < lights.x; i += LIGHTS_AT_ONCE) {
#if RADIUS_TEST
    test_and_add(r, read_lights_from(i), sums);
#else
    sums.counts.x += 1.0;
    add_light(r, read_lights_from(i), sums);
#endif
  }
  write_sums(s, r, sums);
}
