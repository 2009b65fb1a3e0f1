// How much of a light arrives at a surface point, by the light's shadow maps: 0 hidden … 1 seen.
#include "lights.glsl"
#include "cube.glsl"

#if SHADOWS
uniform sampler2D shadow_depth;    // all maps side by side
uniform number_table shadow_records;  // what each is: shared.h

vec4 shadow_record(int k) { return table_at(shadow_records, k); }

// 1 if the map's texel lets light through to this depth; beside the map its border counts.
float shadow_test(ivec2 corner, ivec2 texel, float depth) {
  texel = corner + clamp(texel, ivec2(0), ivec2(SHADOW_TEXELS - 1));
  return depth <= texelFetch(shadow_depth, texel, 0).r ? 1.0 : 0.0;
}

float shadow_filtered(ivec2 corner, vec2 at, float depth) {
#if SHADOW_FILTER == SHADOW_FILTER_NONE
  return shadow_test(corner, ivec2(floor(at)), depth);
#elif SHADOW_FILTER == SHADOW_FILTER_2X2
  vec2 base = floor(at - 0.5);
  vec2 share = at - 0.5 - base;
  ivec2 texel = ivec2(base);
  return mix(mix(shadow_test(corner, texel, depth), shadow_test(corner, texel + ivec2(1, 0), depth), share.x),
             mix(shadow_test(corner, texel + ivec2(0, 1), depth), shadow_test(corner, texel + ivec2(1, 1), depth), share.x),
             share.y);
#else
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) sum += shadow_test(corner, ivec2(floor(at)) + ivec2(x, y), depth);
  return sum / 9.0;
#endif
}

// A light as its maps know it.
struct Caster {
  int map;  // its first one; -1: none
#if LIGHT_KINDS
  int kind;
#endif
  vec3 position;
};
#if LIGHT_KINDS
#define CASTER(map, kind, position) Caster(map, kind, position)
#else
#define CASTER(map, kind, position) Caster(map, position)
#endif
#if LIGHTS_AT_ONCE == 4
Caster caster_of(Light some, int k) {
  return CASTER(some.shadow_map[k], some.kind[k], vec3(some.position[0][k], some.position[1][k], some.position[2][k]));
}
#else
Caster caster_of(Light light) { return CASTER(light.shadow_map, light.kind, light.position); }
#endif

mat4 shadow_matrix(int map) {
  int first = map * SHADOW_MAP_TEXELS;
  return mat4(shadow_record(first), shadow_record(first + 1), shadow_record(first + 2), shadow_record(first + 3));
}

// Of a point light's six maps.
int shadow_face(Caster light, vec3 position) {
#if SHADOW_TRIES_FACES
  for (int face = 0; face < 6; ++face) {
    vec4 clip = shadow_matrix(light.map + face) * vec4(position, 1.0);
    if (clip.w > 0.0 && all(lessThanEqual(abs(clip.xy), clip.ww))) return face;
  }
#endif
  return cube_face(position - light.position);
}

int shadow_map_of(Caster light, vec3 position) {
#if LIGHT_KINDS
  if (light.kind == LIGHT_SPOT) return light.map;
  if (light.kind == LIGHT_DIRECTIONAL) {
    float range = dot(position, ray_forward.xyz);
    for (int k = 0; k < SHADOW_CASCADES - 1; ++k)
      if (range < shadow_record((light.map + k) * SHADOW_MAP_TEXELS + 4).w) return light.map + k;
    return light.map + SHADOW_CASCADES - 1;
  }
#endif
  return light.map + shadow_face(light, position);
}

// The point is moved before it is compared, by so many texels of the map as they are large at its place.
float visibility(Caster light, vec3 position, vec3 normal, vec3 to_light) {
  if (light.map < 0) return 1.0;
  int first = shadow_map_of(light, position);
  mat4 clip_from_relative = shadow_matrix(first);
  vec4 rest = shadow_record(first * SHADOW_MAP_TEXELS + 4);
  float texel = rest.z * (clip_from_relative * vec4(position, 1.0)).w;  // w of an orthographic map is 1
  float cosine = max(dot(normal, to_light), 0.1);
  float slope = sqrt(1.0 - min(cosine * cosine, 1.0)) / cosine;
  vec3 moved = position + texel * ((shadow_bias.x + shadow_bias.y * slope) * to_light + shadow_bias.z * normal);
  int map = shadow_map_of(light, moved);  // moved across an edge of a cube it is on another face
  if (map != first) {
    clip_from_relative = shadow_matrix(map);
    rest = shadow_record(map * SHADOW_MAP_TEXELS + 4);
  }
  vec4 clip = clip_from_relative * vec4(moved, 1.0);
  if (!(clip.w > 0.0)) return 1.0;
  vec3 at = clip.xyz / clip.w * 0.5 + 0.5;
  bool beside = rest.w == 0.0 && at.xy != clamp(at.xy, 0.0, 1.0);  // of a spot that is wider than a map can be
  if (at.z > 1.0 || beside) return 1.0;                            // the map does not know
  return shadow_filtered(ivec2(rest.xy), at.xy * float(SHADOW_TEXELS), at.z);
}
#endif
