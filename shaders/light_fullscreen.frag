// Every pixel loops over every light; with RADIUS_TEST it shades only those in range.
#include "light_output.glsl"

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) discard;
  Sums sums = no_sums();
  for (int i = 0; i < lights.x; ++i) {
    Light light = read_light(i);
    sums.counts.x += 1.0;
#if RADIUS_TEST
    if (!reaches(light, s.position)) continue;
#endif
    shade_pair(s, light, sums);
  }
  write_sums(s, sums);
}
