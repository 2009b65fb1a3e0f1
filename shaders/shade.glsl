// What one light does to one surface point. Every lighting method calls this and nothing else.
// A light's colour is the radiance that a white Lambert surface sends back when it faces the light at unit
// attenuation, so no 1/pi appears below.
#include "surface.glsl"
#include "lights.glsl"
#include "shadow.glsl"

struct Lighting {
  vec3 diffuse;   // without albedo
  vec3 specular;
};

const float kPi = 3.14159265358979;
#if ATTENUATION == ATTENUATION_GLTF
const float kLeastSpotEdge = 1e-3;  // KHR_lights_punctual, "Inner and Outer Cone Angles"
#else
const float kLeastSpotEdge = 1e-4;
#endif

// `range` is the light's own, whatever range.kind makes of its end.
float attenuation(float d, float range) {
#if ATTENUATION == ATTENUATION_NONE
  return 1.0;
#elif ATTENUATION == ATTENUATION_LINEAR
  return 1.0 - clamp(d / range, 0.0, 1.0);
#elif ATTENUATION == ATTENUATION_QUADRATIC
  return 1.0 / (1.0 + 0.7 * d + 1.8 * d * d);
#elif ATTENUATION == ATTENUATION_RAMP
  float x = 4.0 * d / range;
  return 1.0 / max(1.0, 0.2 + 0.4 * x + 0.4 * x * x);
#elif ATTENUATION == ATTENUATION_INVERSE_LINEAR
  return 1.0 / (1.0 + 9.0 * d / range);
#elif ATTENUATION == ATTENUATION_GLTF
  // KHR_lights_punctual, "Range Property"; nearer than 0.1 mm it stops growing.
  float x = d / range;
  return clamp(1.0 - x * x * x * x, 0.0, 1.0) / max(d * d, 1e-8);
#else
  // Karis 2013, "Real Shading in Unreal Engine 4"; nearer than 1 cm it stops growing, or a pixel on a lamp overflows.
  float x = d / range;
  float window = clamp(1.0 - x * x * x * x, 0.0, 1.0);
  return window * window / max(d * d, 1e-4);
#endif
}

// ---- highlights: radiance per unit of light, N.L included where the model has it ---------------------------

// A lobe from roughness is normalised, so that a wet patch glitters and dry earth stays matte: (e + 2) / 8 keeps the
// reflected energy about constant (Akenine-Moeller et al. 2018, "Real-Time Rendering", section 9.8). A constant
// exponent is the tutorials' and is left as they print it.
float lobe_scale(float exponent) { return shading.x >= 0.0 ? 1.0 : (exponent + 2.0) / 8.0; }

// Base 0 with exponent 0 is left open by GLSL: the lab says 1, as C does.
float lobe(float cosine, float exponent) {
  return lobe_scale(exponent) * (exponent > 0.0 ? pow(max(cosine, 0.0), exponent) : 1.0);
}

// Walter et al. 2007 (D), Heitz 2014 (correlated Smith visibility), Schlick 1994 (Fresnel); as glTF 2.0, appendix B.
float D_GGX(float n_dot_h, float alpha) {
  float a2 = alpha * alpha;
  float k = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
  return a2 / (kPi * k * k);
}
float V_SmithGGX(float n_dot_l, float n_dot_v, float alpha) {
  float a2 = alpha * alpha;
  float l = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - a2) + a2);
  float v = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - a2) + a2);
  return 0.5 / max(l + v, 1e-7);
}
// At grazing angles all is reflected, but by what reflects less than 2 % when it is faced: there is no such material, a
// black metal stands for "reflects nothing" (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 3.1.1).
// The cosine may come out a little above 1: a negative base is no number (`pow-negative-base`).
vec3 F_Schlick(vec3 f0, float v_dot_h) {
  float f90 = min(50.0 * max(max(f0.r, f0.g), f0.b), 1.0);
  return f0 + (f90 - f0) * pow(max(1.0 - v_dot_h, 0.0), 5.0);
}

Lighting reflected(Surface s, vec3 to_light, float n_dot_l) {
#if SHADING_MODEL == MODEL_LAMBERT
  return Lighting(vec3(n_dot_l), vec3(0.0));
#else
  vec3 to_eye = ray_forward.w > 0.5 ? -ray_forward.xyz : -normalize(s.position);
#if SHADING_MODEL == MODEL_PHONG
  return Lighting(vec3(n_dot_l), s.f0 * lobe(dot(reflect(-to_light, s.normal), to_eye), s.exponent));
#else
  vec3 half_way = normalize(to_light + to_eye);
  float n_dot_h = max(dot(s.normal, half_way), 0.0);
#if SHADING_MODEL == MODEL_BLINN_PHONG
  return Lighting(vec3(n_dot_l), s.f0 * lobe(n_dot_h, s.exponent));
#else
  float roughness = max(s.roughness, 0.045);  // part of the model: below it the lobe is narrower than a float resolves
  float alpha = roughness * roughness;
  float n_dot_v = max(dot(s.normal, to_eye), 1e-4);
  vec3 fresnel = F_Schlick(s.f0, max(dot(to_eye, half_way), 0.0));
  return Lighting(n_dot_l * (1.0 - fresnel),
                  n_dot_l * kPi * D_GGX(n_dot_h, alpha) * V_SmithGGX(n_dot_l, n_dot_v, alpha) * fresnel);
#endif
#endif
#endif
}

Lighting shade(Surface s, Light light) {
  Lighting none = Lighting(vec3(0.0), vec3(0.0));
  vec3 to_light = light.position - s.position;
  float d = length(to_light);
  float strength = 1.0;
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) {
    to_light = -light.direction;
  } else
#endif
  {
#if !MISTAKE_VOLUME_WITHOUT_DISTANCE_TEST
    if (d >= light.range) return none;
#endif
    to_light /= max(d, 1e-6);  // a light on the surface must not divide by 0
    strength = attenuation(d, light.profile);
#if LIGHT_KINDS
    if (dot(light.coefficients, vec3(1.0)) > 0.0) strength = 1.0 / dot(light.coefficients, vec3(1.0, d, d * d));
    // Between the cones the glTF extension's square of a linear ramp (KHR_lights_punctual, inner and outer angles).
    if (light.kind == LIGHT_SPOT) {
#if SPOT_COS_POWER
      strength *= pow(max(dot(-to_light, light.direction), 0.0), light.inner_cos);
#else
      float edge = clamp((dot(-to_light, light.direction) - light.outer_cos) / max(light.inner_cos - light.outer_cos, kLeastSpotEdge), 0.0, 1.0);
      strength *= edge * edge;
#endif
    }
#endif
#if RANGE_WINDOWED
    float x = d / light.range;
    float window = clamp(1.0 - x * x * x * x, 0.0, 1.0);
    strength *= window * window;
#endif
  }
  float n_dot_l = dot(s.normal, to_light);
#if MISTAKE_SPECULAR_UNGATED
  n_dot_l = max(n_dot_l, 0.0);
#else
  if (!(n_dot_l > 0.0)) return none;  // turned away: no diffuse, and no highlight either (`specular-ungated`)
#endif
  Lighting r = reflected(s, to_light, n_dot_l);
#if SHADOWS
  strength *= visibility(light, s.position, s.normal, to_light);
#endif
  vec3 arriving = light.colour * strength;
  return Lighting(arriving * r.diffuse, arriving * r.specular);
}
