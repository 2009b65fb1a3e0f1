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

#if LIGHTS_AT_ONCE == 4
bvec4 above(vec4 a, float b) { return greaterThan(a, vec4(b)); }
bvec4 is(ivec4 a, int b) { return equal(a, ivec4(b)); }
vec4 chosen(bvec4 which, vec4 a, vec4 b) { return mix(b, a, which); }
mat3x4 chosen(bvec4 which, mat3x4 a, mat3x4 b) { return mat3x4(mix(b[0], a[0], which), mix(b[1], a[1], which), mix(b[2], a[2], which)); }
#else
bool above(float a, float b) { return a > b; }
bool is(int a, int b) { return a == b; }
float chosen(bool which, float a, float b) { return which ? a : b; }
vec3 chosen(bool which, vec3 a, vec3 b) { return which ? a : b; }
#endif

#if LIGHT_KINDS
// Between the cones the glTF extension's square of a linear ramp (KHR_lights_punctual, inner and outer angles).
lane spot_edge(Light light, lane3 to_light) {
  lane cosine = -(to_light[0] * light.direction[0] + to_light[1] * light.direction[1] + to_light[2] * light.direction[2]);
#if SPOT_COS_POWER
  return pow(max(cosine, 0.0), light.inner_cos);
#else
#if ATTENUATION == ATTENUATION_GLTF
  const float kLeastEdge = 1e-3;  // KHR_lights_punctual, "Inner and Outer Cone Angles"
#else
  const float kLeastEdge = 1e-4;
#endif
  lane edge = clamp((cosine - light.outer_cos) / max(light.inner_cos - light.outer_cos, kLeastEdge), 0.0, 1.0);
  return edge * edge;
#endif
}

lane falloff_of_its_own(lane3 k, lane d) { return 1.0 / (k[0] + k[1] * d + k[2] * d * d); }
#endif

// Of what lights send this way: 0 at and beyond their range.
lane arriving_share(Light light, Way way) {
  lane share = attenuation(way.d, light.profile);
#if LIGHT_KINDS
  lane3 k = light.coefficients;
  share = chosen(above(k[0] + k[1] + k[2], 0.0), falloff_of_its_own(k, way.d), share);
  share = chosen(is(light.kind, LIGHT_SPOT), share * spot_edge(light, way.direction), share);
#endif
#if RANGE_WINDOWED
  lane window = window_of(way.d / light.range);
  share *= window * window;
#endif
#if !MISTAKE_VOLUME_WITHOUT_DISTANCE_TEST
  share = if_less(way.d, light.range, share);
#endif
#if LIGHT_KINDS
  share = chosen(is(light.kind, LIGHT_DIRECTIONAL), lane(1.0), share);
#endif
  return share;
}

#if SHADOWS
// Which lights' maps are worth asking, as a map is a dozen texels.
lane asked_of(Receiver r, Light light, Way way, lane arriving) {
  lane asked = chosen(above(lane(light.shadow_map), -0.5), arriving, lane(0.0));
#if !MISTAKE_SPECULAR_UNGATED
  asked = chosen(above(dots(way.direction, r.normal), 0.0), asked, lane(0.0));
#endif
  return asked;
}

// What is left of `arriving` behind what stands in the way.
#if LIGHTS_AT_ONCE == 4
int first_above_zero(vec4 a) { return a.x > 0.0 ? 0 : a.y > 0.0 ? 1 : a.z > 0.0 ? 2 : a.w > 0.0 ? 3 : 4; }
vec4 unhidden(Receiver r, Light light, Way way, vec4 arriving) {
  vec4 asked = asked_of(r, light, way, arriving);
  for (int k = first_above_zero(asked); k < 4; k = first_above_zero(asked)) {
    vec3 to_light = vec3(way.direction[0][k], way.direction[1][k], way.direction[2][k]);
    arriving[k] *= visibility(caster_of(light, k), r.position, r.normal, to_light);
    asked[k] = 0.0;
  }
  return arriving;
}
#else
float unhidden(Receiver r, Light light, Way way, float arriving) {
  if (asked_of(r, light, way, arriving) > 0.0) arriving *= visibility(caster_of(light), r.position, r.normal, way.direction);
  return arriving;
}
#endif
#endif

// The sum of LIGHTS_AT_ONCE lights; highlights without highlight_scale(), which a sum of lights is given once.
Lighting shade(Receiver r, Light light) {
  Way way = way_between(r.position, light.position);
#if LIGHT_KINDS
  way.direction = chosen(is(light.kind, LIGHT_DIRECTIONAL), -light.direction, way.direction);
#endif
  lane arriving = arriving_share(light, way);
#if SHADOWS
  arriving = unhidden(r, light, way, arriving);
#endif
  return reflected(r, way.direction, light.colour, arriving);
}
