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

int filled_up(int count) { return (count + LIGHTS_AT_ONCE - 1) / LIGHTS_AT_ONCE * LIGHTS_AT_ONCE; }

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) {
    write_background();
    return;
  }
  Receiver r = receiver_of(s);
  Sums sums = no_sums();
  ivec2 own = ivec2(texelFetch(light_lists, cluster_of(s.position)).xy);
  own.y = filled_up(own.y);
  // One loop for both lists: llvmpipe runs a loop's body once even if no pixel has a turn.
  for (int i = 0; i < own.y + everywhere.y; i += LIGHTS_AT_ONCE) {
    bool is_own = i < own.y;
    test_and_add(r, read_listed(is_own ? own.x : everywhere.x, is_own ? i : i - own.y), sums);
  }
  write_sums(s, r, sums);
}
