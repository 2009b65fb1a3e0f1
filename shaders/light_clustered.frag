// Each pixel reads the list of its cluster, and the list of the lights that are everywhere.
#include "light_loop.glsl"

uniform usamplerBuffer light_lists;  // see LightClusters::words(): a texel holds four
uniform vec2 slices;                 // slice = log2(depth) * x + y
uniform ivec2 everywhere;            // the texel at which that list starts, how long it is

// Depth is the distance along the view axis, whatever the depth buffer holds.
int cluster_of(vec3 position) {
  float depth = max(dot(position, ray_forward.xyz), planes.x);
  int slice = clamp(int(floor(log2(depth) * slices.x + slices.y)), 0, CLUSTER_SLICES - 1);
  ivec2 cell = ivec2(gl_FragCoord.xy * viewport.zw * vec2(CLUSTER_COLUMNS, CLUSTER_ROWS));
  return (slice * CLUSTER_ROWS + cell.y) * CLUSTER_COLUMNS + cell.x;
}

Light read_listed(int texel, int i) {
  ivec4 four = ivec4(texelFetch(light_lists, texel + i / 4));
#if LIGHTS_AT_ONCE == 4
  return read_lights(four);
#else
  return read_light(four[i % 4]);
#endif
}

void add_list(Receiver r, ivec2 list, inout Sums sums) {
  for (int i = 0; i < list.y; i += LIGHTS_AT_ONCE) test_and_add(r, read_listed(list.x, i), sums);
}

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) discard;
  Receiver r = receiver_of(s);
  Sums sums = no_sums();
  add_list(r, ivec2(texelFetch(light_lists, cluster_of(s.position)).xy), sums);
  add_list(r, everywhere, sums);
  write_sums(s, r, sums);
}
