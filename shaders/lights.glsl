// Light records from a buffer texture: no limit of a uniform block, and a fetch without levels or rows.
#include "shared.h"
#include "lanes.glsl"

// Have some lights more than a place, a range and a colour? The others are plain: points that fall off as the settings say, without
// a shadow.
#define MIXED_LIGHTS (LIGHT_KINDS || SHADOWS)

#if LIGHTS_AT_ONCE == 4
#define lane_int ivec4
#else
#define lane_int int
#endif

// One light, or LIGHTS_AT_ONCE of them (lanes.glsl).
struct Light {
  lane3 position;  // relative to the camera, world axes
  lane range;      // no light at or beyond it
  lane profile;    // the range that the falloff is a function of
  lane3 colour;    // times light_scale.x
#if SHADOWS
  lane_int shadow_map;  // its first one; -1: none
#endif
#if LIGHT_KINDS
  lane_int kind;
  lane3 direction;            // unit, from the light
  lane inner_cos, outer_cos;  // of a spot; under SPOT_COS_POWER the inner is the cosine's exponent, and no edge
  lane3 coefficients;         // of its own falloff 1/(x + y d + z d2); all 0: the settings' profile
#endif
};

uniform number_table light_data;    // LIGHT_TEXELS each: what every pair needs
uniform number_table light_traits;  // LIGHT_TRAIT_TEXELS each: the rest

vec4 light_trait(int i, int k) { return table_at(light_traits, i * LIGHT_TRAIT_TEXELS + k); }

// Has it no end, so that no proxy can hold it?
bool endless(float range, int i) {
#if LIGHT_KINDS
  if (int(light_trait(i, 0).x) == LIGHT_DIRECTIONAL) return true;
#endif
  return range >= 1e30;  // kEndless of renderer/scene/scene.h
}

#if LIGHTS_AT_ONCE == 4
mat4 four_texels(number_table of, ivec4 i) {
  return transpose(mat4(table_at(of, i.x), table_at(of, i.y), table_at(of, i.z), table_at(of, i.w)));
}

// Of plain lights: the compiler drops whatever else there is to a light.
Light read_plain_lights(ivec4 i) {
  mat4 place = four_texels(light_data, i * LIGHT_TEXELS), colour = four_texels(light_data, i * LIGHT_TEXELS + 1);
  Light some;
  some.position = lane3(place[0], place[1], place[2]);
  some.range = place[3];
  some.profile = colour[3];
  some.colour = lane3(colour[0], colour[1], colour[2]);
#if SHADOWS
  some.shadow_map = ivec4(-1);
#endif
#if LIGHT_KINDS
  some.kind = ivec4(LIGHT_POINT);
  some.direction = some.coefficients = lane3(0.0);
  some.inner_cos = some.outer_cos = lane(0.0);
#endif
  return some;
}

Light read_lights(ivec4 i) {
  Light some = read_plain_lights(i);
#if MIXED_LIGHTS
  mat4 trait = four_texels(light_traits, i * LIGHT_TRAIT_TEXELS);
#if SHADOWS
  some.shadow_map = ivec4(trait[2]);
#endif
#if LIGHT_KINDS
  mat4 aim = four_texels(light_traits, i * LIGHT_TRAIT_TEXELS + 1), rest = four_texels(light_traits, i * LIGHT_TRAIT_TEXELS + 2);
  some.kind = ivec4(trait[0]);
  some.direction = lane3(aim[0], aim[1], aim[2]);
  some.inner_cos = aim[3];
  some.outer_cos = rest[0];
  some.coefficients = lane3(rest[1], rest[2], rest[3]);
#endif
#endif
  return some;
}

// Is any of them near enough? Whatever a spot's cone.
bool reaches(Light some, vec3 position) {
  bvec4 near = lessThan(squares(some.position - in_all_lanes(position)), some.range * some.range);
#if LIGHT_KINDS
  near = bvec4(uvec4(near) | uvec4(equal(some.kind, ivec4(LIGHT_DIRECTIONAL))));
#endif
  return any(near);
}

// All lights in fours: to .x plain ones, from there to .y all that are not.
#if MIXED_LIGHTS
vec4 light_order(int k) { return table_at(light_traits, (lights.x + DARK_LIGHTS) * LIGHT_TRAIT_TEXELS + k); }
ivec2 light_fours() { return ivec2(light_order(0).xy); }
Light read_plain_four(int k) { return read_plain_lights(ivec4(light_order(1 + k))); }
Light read_four(int k) { return read_lights(ivec4(light_order(1 + k))); }
#else
ivec2 light_fours() { return ivec2((lights.x + 3) / 4); }
Light read_plain_four(int k) { return read_plain_lights(4 * k + ivec4(0, 1, 2, 3)); }
#endif
#else
Light read_light(int i) {
  Light light;
  vec4 place = table_at(light_data, i * LIGHT_TEXELS), colour = table_at(light_data, i * LIGHT_TEXELS + 1);
  light.position = place.xyz;
  light.range = place.w;
  light.profile = colour.w;
  light.colour = colour.rgb;
#if SHADOWS || LIGHT_KINDS
  vec4 trait = light_trait(i, 0);
#if SHADOWS
  light.shadow_map = int(trait.z);
#endif
#if LIGHT_KINDS
  vec4 aim = light_trait(i, 1), rest = light_trait(i, 2);
  light.kind = int(trait.x);
  light.direction = aim.xyz;
  light.inner_cos = aim.w;
  light.outer_cos = rest.x;
  light.coefficients = rest.yzw;
#endif
#endif
  return light;
}

// Does the light reach this point at all? Regardless of the surface's side and the light's colour.
bool reaches(Light light, vec3 position) {
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) return true;
  vec3 from_light = position - light.position;
  float d = length(from_light);
  return d < light.range && (light.kind == LIGHT_POINT || dot(from_light, light.direction) > light.outer_cos * d);
#else
  return distance(position, light.position) < light.range;
#endif
}
#endif
