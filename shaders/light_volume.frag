// The pixels under one light's volume.
#include "light_output.glsl"

flat in int light;

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) discard;
  Receiver r = receiver_of(s);
  Sums sums = no_sums();
  sums.counts.x = 1.0;
  add_light(r, read_light(light), sums);
  write_sums(s, r, sums);
}
