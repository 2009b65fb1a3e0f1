// One work group per tile of TILE x TILE pixels. Its threads test a batch of lights against the tile, one light each,
// and mark those that may reach it; then each thread shades its own pixel with the marked ones, and the next batch
// follows. So there is no list, no limit to its length, and the lights keep their order.
#define COMPUTE
#include "light_loop.glsl"

layout(local_size_x = TILE, local_size_y = TILE) in;

const int kBatch = TILE * TILE;

shared uint tile_near, tile_far;     // depths of the tile's surfaces; bits of positive floats sort as the floats do
shared uint marked[kBatch / 32];  // one bit per light of the batch

// How far a point is beyond the plane through the eye, or parallel to the view axis, that bounds the tile.
float beyond(float ndc, vec3 axis, vec3 point) {
  float half_extent = length(axis), aside = dot(point, axis) / half_extent;
  if (ray_forward.w > 0.5) return aside - ndc * half_extent;
  float slope = ndc * half_extent;
  return (aside - slope * dot(point, ray_forward.xyz)) * inversesqrt(1.0 + slope * slope);
}

bool may_reach_tile(int i) {
  vec4 place = table_at(light_data, i * LIGHT_TEXELS);
  if (endless(place.w, i)) return true;
  vec3 light = place.xyz;
  float range = place.w + 1e-5 * (place.w + length(light));  // positions and planes are in float
  float depth = dot(light, ray_forward.xyz);
  if (depth + range < uintBitsToFloat(tile_near) || depth - range > uintBitsToFloat(tile_far)) return false;
  vec2 low = ndc_of_pixel(vec2(gl_WorkGroupID.xy * uint(TILE)));
  vec2 high = ndc_of_pixel(vec2((gl_WorkGroupID.xy + 1u) * uint(TILE)));
  return beyond(low.x, ray_right.xyz, light) > -range && beyond(high.x, ray_right.xyz, light) < range &&
         beyond(low.y, ray_up.xyz, light) > -range && beyond(high.y, ray_up.xyz, light) < range;
}

void mark(int batch) {
  uint thread = gl_LocalInvocationIndex;
  if (thread < uint(kBatch / 32)) marked[thread] = 0u;
  barrier();
  int light = batch + int(thread);
  if (light < lights.x && may_reach_tile(light)) atomicOr(marked[thread / 32u], 1u << (thread % 32u));
  barrier();
}

// The light of the lowest bit, which is cleared; a dark one where none is left.
int take_light(int first, inout uint bits) {
  if (bits == 0u) return lights.x;
  int light = first + findLSB(bits);
  bits &= bits - 1u;
  return light;
}
Light take_lights(int first, inout uint bits) {
#if LIGHTS_AT_ONCE == 4
  ivec4 four;
  for (int k = 0; k < 4; ++k) four[k] = take_light(first, bits);
  return read_lights(four);
#else
  return read_light(take_light(first, bits));
#endif
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy), last = ivec2(viewport.xy) - 1;
  Surface s = read_surface(min(texel, last));
  s.present = s.present && all(lessThanEqual(texel, last));
  if (gl_LocalInvocationIndex == 0u) tile_near = ~0u, tile_far = 0u;
  barrier();
  if (s.present) {
    uint depth = floatBitsToUint(max(dot(s.position, ray_forward.xyz), 0.0));
    atomicMin(tile_near, depth);
    atomicMax(tile_far, depth);
  }
  barrier();
  Receiver r = receiver_of(s);
  Sums sums = no_sums();
  int end = tile_near > tile_far ? 0 : lights.x;  // nothing to light: the same for all threads of the group
  for (int batch = 0; batch < end; batch += kBatch) {
    mark(batch);
    for (int i = 0; i < kBatch / 32; ++i) {
      uint rest = s.present ? marked[i] : 0u;
      while (rest != 0u) test_and_add(r, take_lights(batch + i * 32, rest), sums);
    }
    barrier();
  }
  if (s.present) write_sums(s, r, sums);
}
