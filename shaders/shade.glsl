// What lights do to a surface point. Every lighting method calls this and nothing else.
#include "surface.glsl"
#include "lights.glsl"
#include "pair.glsl"
#include "shadow.glsl"

vec3 to_eye_of(vec3 position) { return ray_forward.w > 0.5 ? -ray_forward.xyz : -normalize(position); }

Receiver receiver_of(Surface s) {
  return make_receiver(s.position, s.normal, to_eye_of(s.position), s.f0, s.exponent, s.roughness);
}
vec3 highlight_scale(Receiver r) { return highlight_scale(r, shading.x >= 0.0); }

#if LIGHT_KINDS
// Between the cones the glTF extension's square of a linear ramp (KHR_lights_punctual, inner and outer angles).
float spot_edge(Light light, vec3 to_light) {
  float cosine = dot(-to_light, light.direction);
#if SPOT_COS_POWER
  return pow(max(cosine, 0.0), light.inner_cos);
#else
#if ATTENUATION == ATTENUATION_GLTF
  const float kLeastEdge = 1e-3;  // KHR_lights_punctual, "Inner and Outer Cone Angles"
#else
  const float kLeastEdge = 1e-4;
#endif
  float edge = clamp((cosine - light.outer_cos) / max(light.inner_cos - light.outer_cos, kLeastEdge), 0.0, 1.0);
  return edge * edge;
#endif
}
#endif

// Of what lights send this way: 0 at and beyond their range.
lane arriving_share(Light light, Way way) {
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) return 1.0;
#endif
  lane share = attenuation(way.d, light.profile);
#if LIGHT_KINDS
  if (dot(light.coefficients, vec3(1.0)) > 0.0) share = 1.0 / dot(light.coefficients, vec3(1.0, way.d, way.d * way.d));
  if (light.kind == LIGHT_SPOT) share *= spot_edge(light, way.direction);
#endif
#if RANGE_WINDOWED
  lane window = window_of(way.d / light.range);
  share *= window * window;
#endif
#if MISTAKE_VOLUME_WITHOUT_DISTANCE_TEST
  return share;
#else
  return if_less(way.d, light.range, share);
#endif
}

// The sum of LIGHTS_AT_ONCE lights; highlights without highlight_scale(), which a sum of lights is given once.
Lighting shade(Receiver r, Light light) {
  Way way = way_between(r.position, light.position);
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) way.direction = -light.direction;
#endif
  lane arriving = arriving_share(light, way);
#if SHADOWS
  bool asked = arriving > 0.0;  // a map is a dozen texels
#if !MISTAKE_SPECULAR_UNGATED
  asked = asked && dot(r.normal, way.direction) > 0.0;
#endif
  if (asked) arriving *= visibility(light, r.position, r.normal, way.direction);
#endif
  return reflected(r, way.direction, light.colour, arriving);
}
