// Numbers of LIGHTS_AT_ONCE lights side by side, 1 or 4. A light's arithmetic is one long chain in which each step waits
// for the one before it; with four lights there are other steps to do meanwhile. Four vectors are a matrix, a row each.
// Sums are written out in one order, so that a light is worth the same bits alone and beside others.
// Only what loops over more lights than a few takes four.
#ifndef LOOPS_OVER_LIGHTS
#define LOOPS_OVER_LIGHTS 0
#endif
#if LOOPS_OVER_LIGHTS && MANY_LIGHTS
#define LIGHTS_AT_ONCE 4
#else
#define LIGHTS_AT_ONCE 1
#endif

#if LIGHTS_AT_ONCE == 4
#define lane vec4
#define lane3 mat3x4
lane3 in_all_lanes(vec3 v) { return outerProduct(vec4(1.0), v); }
lane dots(lane3 a, vec3 b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }
lane squares(lane3 a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }
lane3 scaled(lane3 a, lane by) { return lane3(a[0] * by, a[1] * by, a[2] * by); }
vec3 weighted_sum(lane3 a, lane weight) { return weight * a; }
vec3 weighted_sum(lane3 a, lane3 weight) { return vec3(dot(a[0], weight[0]), dot(a[1], weight[1]), dot(a[2], weight[2])); }
lane3 times(lane a, vec3 b) { return outerProduct(a, b); }
lane if_less(lane a, lane b, lane x) { return mix(lane(0.0), x, lessThan(a, b)); }  // else 0
#else
#define lane real
#define lane3 vec3
lane3 in_all_lanes(vec3 v) { return v; }
lane dots(lane3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
lane squares(lane3 a) { return a.x * a.x + a.y * a.y + a.z * a.z; }
lane3 scaled(lane3 a, lane by) { return a * by; }
vec3 weighted_sum(lane3 a, lane weight) { return a * weight; }
vec3 weighted_sum(lane3 a, lane3 weight) { return a * weight; }
lane3 times(lane a, vec3 b) { return a * b; }
lane if_less(lane a, lane b, lane x) { return a < b ? x : real(0.0); }
#endif
