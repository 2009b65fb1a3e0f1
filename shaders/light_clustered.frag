// Each pixel reads the list of its cluster, and the list of the lights that are everywhere.
#include "light_output.glsl"

uniform usampler2D light_lists;  // see LightClusters::words()
uniform vec2 slices;             // slice = log2(depth) * x + y
uniform ivec2 everywhere;        // where that list starts, how long it is

int word(int i) { return int(texelFetch(light_lists, ivec2(i % LIST_TEXTURE_WIDTH, i / LIST_TEXTURE_WIDTH), 0).r); }

// Depth is the distance along the view axis, whatever the depth buffer holds.
int cluster_of(vec3 position) {
  float depth = max(dot(position, ray_forward.xyz), planes.x);
  int slice = clamp(int(floor(log2(depth) * slices.x + slices.y)), 0, CLUSTER_SLICES - 1);
  ivec2 cell = ivec2(gl_FragCoord.xy * viewport.zw * vec2(CLUSTER_COLUMNS, CLUSTER_ROWS));
  return (slice * CLUSTER_ROWS + cell.y) * CLUSTER_COLUMNS + cell.x;
}

void main() {
  Surface s = read_surface(ivec2(gl_FragCoord.xy));
  if (!s.present) discard;
  Sums sums = no_sums();
  int cluster = cluster_of(s.position);
  int start = word(2 * cluster), own = word(2 * cluster + 1);
  for (int i = 0; i < own + everywhere.y; ++i) {
    Light light = read_light(word(i < own ? start + i : everywhere.x + i - own));
    sums.counts.x += 1.0;
    if (reaches(light, s.position)) shade_pair(s, light, sums);
  }
  write_sums(s, sums);
}
