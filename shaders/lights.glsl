// Light records from a float texture: no limit of a uniform block, no storage buffer needed.
#include "shared.h"

struct Light {
  vec3 position;  // relative to the camera, world axes
  float range;    // no light at or beyond it
  float profile;  // the range that the falloff is a function of
#if SHADOWS
  int shadow_map;  // its first one; -1: none
#endif
  vec3 colour;    // times light_scale.x
#if LIGHT_KINDS
  int kind;
  vec3 direction;  // unit, from the light
  float inner_cos, outer_cos;  // of a spot; under SPOT_COS_POWER the inner is the cosine's exponent, and no edge
  vec3 coefficients;  // of its own falloff 1/(x + y d + z d2); all 0: the settings' profile
#endif
};

uniform sampler2D light_data;

vec4 light_texel(int k) { return texelFetch(light_data, ivec2(k % RECORD_TEXTURE_WIDTH, k / RECORD_TEXTURE_WIDTH), 0); }

Light read_light(int i) {
  Light light;
  vec4 place = light_texel(i * LIGHT_TEXELS);
  vec4 colour = light_texel(i * LIGHT_TEXELS + 1);
  light.position = place.xyz;
  light.range = place.w;
  light.colour = colour.rgb;
#if RANGE_IS_PROFILE
  light.profile = light.range;
#else
  light.profile = light_texel(i * LIGHT_TEXELS + 4).x;
#endif
#if SHADOWS
  light.shadow_map = int(light_texel(i * LIGHT_TEXELS + 4).z);
#endif
#if LIGHT_KINDS
  vec4 aim = light_texel(i * LIGHT_TEXELS + 2);
  light.kind = int(colour.w);
  light.direction = aim.xyz;
  light.inner_cos = aim.w;
  vec4 rest = light_texel(i * LIGHT_TEXELS + 3);
  light.outer_cos = rest.x;
  light.coefficients = rest.yzw;
#endif
  return light;
}

// Has it no end, so that no proxy can hold it?
bool endless(Light light) {
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) return true;
#endif
  return light.range >= 1e30;  // kEndless of renderer/scene/scene.h
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
