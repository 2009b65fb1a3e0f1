// Light records from a buffer texture: no limit of a uniform block, and a fetch without levels or rows.
#include "shared.h"
#include "lanes.glsl"

// One light, or LIGHTS_AT_ONCE of them (lanes.glsl). What only some lights have is read of one light at a time.
struct Light {
  lane3 position;  // relative to the camera, world axes
  lane range;      // no light at or beyond it
  lane profile;    // the range that the falloff is a function of
  lane3 colour;    // times light_scale.x
#if SHADOWS
  int shadow_map;  // its first one; -1: none
#endif
#if LIGHT_KINDS
  int kind;
  vec3 direction;              // unit, from the light
  float inner_cos, outer_cos;  // of a spot; under SPOT_COS_POWER the inner is the cosine's exponent, and no edge
  vec3 coefficients;           // of its own falloff 1/(x + y d + z d2); all 0: the settings' profile
#endif
};

uniform samplerBuffer light_data;    // LIGHT_TEXELS each: what every pair needs
uniform samplerBuffer light_traits;  // LIGHT_TRAIT_TEXELS each: the rest

vec4 light_trait(int i, int k) { return texelFetch(light_traits, i * LIGHT_TRAIT_TEXELS + k); }

// Has it no end, so that no proxy can hold it?
bool endless(float range, int i) {
#if LIGHT_KINDS
  if (int(light_trait(i, 0).x) == LIGHT_DIRECTIONAL) return true;
#endif
  return range >= 1e30;  // kEndless of renderer/scene/scene.h
}

#if LIGHTS_AT_ONCE == 4
Light read_lights(ivec4 i) {
  i *= LIGHT_TEXELS;
  mat4 place = transpose(mat4(texelFetch(light_data, i.x), texelFetch(light_data, i.y), texelFetch(light_data, i.z), texelFetch(light_data, i.w)));
  i += 1;
  mat4 light = transpose(mat4(texelFetch(light_data, i.x), texelFetch(light_data, i.y), texelFetch(light_data, i.z), texelFetch(light_data, i.w)));
  return Light(lane3(place[0], place[1], place[2]), place[3], light[3], lane3(light[0], light[1], light[2]));
}
#else
Light read_light(int i) {
  Light light;
  vec4 place = texelFetch(light_data, i * LIGHT_TEXELS), colour = texelFetch(light_data, i * LIGHT_TEXELS + 1);
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

// In the lights' own order, LIGHTS_AT_ONCE of them: there are DARK_LIGHTS after the last.
Light read_lights_from(int first) {
#if LIGHTS_AT_ONCE == 4
  return read_lights(first + ivec4(0, 1, 2, 3));
#else
  return read_light(first);
#endif
}
