// Each pixel reads the list of its cluster, and the list of the lights that are everywhere.
#include "light_loop.glsl"

// How the picture is cut: ClusterGrid of renderer/light/cluster_grid.h.
uniform ivec3 cuts;   // binary logarithm of a tile's side in pixels, columns, slices
uniform vec2 slices;  // slice = log2(depth) * x + y

uniform word_table light_lists;  // see LightClusters::words(): a texel holds four
uniform ivec4 everywhere;            // the texel at which that list starts, how many plain lights come first, the same filled up, how long it is

// The texel at which the list of a place starts, and how long it is. Depth is the distance along the view axis, whatever
// the depth buffer holds.
ivec2 list_of(vec3 position) {
  ivec2 tile = ivec2(gl_FragCoord.xy) >> cuts.x;
  ivec3 clusters = ivec3(table_at(light_lists, tile.y * cuts.y + tile.x).xyz);  // first texel, slice, how many
  float depth = max(dot(position, ray_forward.xyz), planes.x);
  int slice = int(clamp(log2(depth) * slices.x + slices.y, 0.0, float(cuts.z - 1)));
  int k = slice - clusters.y;
  bool listed = k >= 0 && k < clusters.z;
  ivec2 list = ivec2(table_at(light_lists, clusters.x + (listed ? k : 0)).xy);
  return listed ? list : ivec2(0);
}

ivec4 listed_four(int texel, int i) { return ivec4(table_at(light_lists, texel + i / 4)); }

// ALL_LISTED_PLAIN: what is no plain light is everywhere.
Light read_listed(int texel, int i) {
#if LIGHTS_AT_ONCE == 1
  return read_light(listed_four(texel, i)[i % 4]);
#elif ALL_LISTED_PLAIN
  return read_plain_lights(listed_four(texel, i));
#else
  return read_lights(listed_four(texel, i));
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
  ivec2 own = list_of(s.position);
  own.y = filled_up(own.y);
#if LIGHTS_AT_ONCE == 4
  int by_all = everywhere.z;
#else
  int by_all = everywhere.w - (everywhere.z - everywhere.y);
#endif
  // One loop for both lists: llvmpipe runs a loop's body once even if no pixel has a turn.
  for (int i = 0; i < own.y + by_all; i += LIGHTS_AT_ONCE) {
    bool is_own = i < own.y;
    int k = is_own ? i : i - own.y;
#if LIGHTS_AT_ONCE == 1
    if (!is_own && k >= everywhere.y) k += everywhere.z - everywhere.y;
#endif
    test_and_add(r, read_listed(is_own ? own.x : everywhere.x, k), sums);
  }
#if LIGHTS_AT_ONCE == 4 && MIXED_LIGHTS
  for (int i = everywhere.z; i < everywhere.w; i += 4) test_and_add(r, read_lights(listed_four(everywhere.x, i)), sums);
#endif
  write_sums(s, r, sums);
}
