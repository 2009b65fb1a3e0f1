// How much of a light arrives, by distance and, of a spot, by direction.
#include "lights.glsl"

#if ATTENUATION == ATTENUATION_GLTF
const float kLeastSpotEdge = 1e-3;  // KHR_lights_punctual, "Inner and Outer Cone Angles"
#else
const float kLeastSpotEdge = 1e-4;
#endif

// 1 - x^4, down to 0 where x = 1
lane window_of(lane x) {
  lane x2 = x * x;
  return clamp(1.0 - x2 * x2, 0.0, 1.0);
}

// `range` is the lights' own, whatever range.kind makes of its end.
lane attenuation(lane d, lane range) {
#if ATTENUATION == ATTENUATION_NONE
  return lane(1.0);
#elif ATTENUATION == ATTENUATION_LINEAR
  return 1.0 - clamp(d / range, 0.0, 1.0);
#elif ATTENUATION == ATTENUATION_QUADRATIC
  return 1.0 / (1.0 + 0.7 * d + 1.8 * d * d);
#elif ATTENUATION == ATTENUATION_RAMP
  lane x = 4.0 * d / range;
  return 1.0 / max(lane(1.0), 0.2 + 0.4 * x + 0.4 * x * x);
#elif ATTENUATION == ATTENUATION_INVERSE_LINEAR
  return 1.0 / (1.0 + 9.0 * d / range);
#elif ATTENUATION == ATTENUATION_GLTF
  // KHR_lights_punctual, "Range Property"; nearer than 0.1 mm it stops growing.
  return window_of(d / range) / max(d * d, 1e-8);
#else
  // Karis 2013, "Real Shading in Unreal Engine 4"; nearer than 1 cm it stops growing, or a pixel on a lamp overflows.
  lane window = window_of(d / range);
  return window * window / max(d * d, 1e-4);
#endif
}

#if LIGHT_KINDS
// Between the cones the glTF extension's square of a linear ramp (KHR_lights_punctual, inner and outer angles).
float spot_edge(Light light, vec3 to_light) {
  float cosine = dot(-to_light, light.direction);
#if SPOT_COS_POWER
  return pow(max(cosine, 0.0), light.inner_cos);
#else
  float edge = clamp((cosine - light.outer_cos) / max(light.inner_cos - light.outer_cos, kLeastSpotEdge), 0.0, 1.0);
  return edge * edge;
#endif
}
#endif

// What lights leave at a distance: 0 at and beyond their range. to_light: unit.
lane arriving_share(Light light, lane3 to_light, lane d) {
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) return 1.0;
#endif
  lane share = attenuation(d, light.profile);
#if LIGHT_KINDS
  if (dot(light.coefficients, vec3(1.0)) > 0.0) share = 1.0 / dot(light.coefficients, vec3(1.0, d, d * d));
  if (light.kind == LIGHT_SPOT) share *= spot_edge(light, to_light);
#endif
#if RANGE_WINDOWED
  lane window = window_of(d / light.range);
  share *= window * window;
#endif
#if MISTAKE_VOLUME_WITHOUT_DISTANCE_TEST
  return share;
#else
  return if_less(d, light.range, share);
#endif
}
