// What one light does to one surface point. Every lighting method calls this and nothing else.
// A light's colour is the radiance that a white Lambert surface sends back when it faces the light at unit
// attenuation, so no 1/pi appears below. A pixel asks this of many lights: what no light changes is worked out before the
// loop and after it, and there is no branch, since a group of pixels would take both of its sides.
#include "surface.glsl"
#include "attenuation.glsl"
#include "shadow.glsl"

struct Lighting {
  vec3 diffuse;   // without albedo
  vec3 specular;
};

// A surface as lights find it.
struct Receiver {
  vec3 position;  // relative to the camera, world axes
  vec3 normal;    // world, unit
  vec3 to_eye;    // unit
  float n_dot_v;
  vec3 f0;
  float exponent;  // of (Blinn-)Phong's highlight
  // Of the microfacet model:
  vec3 grazing;   // what is added to f0 at grazing angles
  float alpha2;   // roughness^4
  float masking;  // of V_SmithGGX: its root without the light
};

vec3 to_eye_of(vec3 position) { return ray_forward.w > 0.5 ? -ray_forward.xyz : -normalize(position); }

// At grazing angles all is reflected, but by what reflects less than 2 % when it is faced: there is no such material, a
// black metal stands for "reflects nothing" (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 3.1.1).
vec3 grazing_of(vec3 f0) { return min(50.0 * max(max(f0.r, f0.g), f0.b), 1.0) - f0; }

Receiver receiver_of(Surface s) {
  Receiver r;
  r.position = s.position;
  r.normal = s.normal;
  r.to_eye = to_eye_of(s.position);
  r.n_dot_v = dot(s.normal, r.to_eye);
  r.f0 = s.f0;
  r.exponent = s.exponent;
  r.grazing = grazing_of(s.f0);
  float alpha = max(s.roughness, 0.045);  // part of the model: below it the lobe is narrower than a float resolves
  alpha *= alpha;
  r.alpha2 = alpha * alpha;
#if SHADING_MODEL == MODEL_GGX
  r.n_dot_v = max(r.n_dot_v, 1e-4);
#endif
  r.masking = sqrt(r.n_dot_v * r.n_dot_v * (1.0 - r.alpha2) + r.alpha2);
  return r;
}

// ---- highlights: radiance per unit of light, without N.L and highlight_scale() ---------------------------------

// cosine^exponent. Base 0 with exponent 0 is left open by GLSL: the lab says 1, as C does.
lane lobe(lane cosine, float exponent) { return exp2(exponent * log2(max(cosine, 1e-37))); }

// A lobe from roughness is normalised, so that a wet patch glitters and dry earth stays matte: (e + 2) / 8 keeps the
// reflected energy about constant (Akenine-Moeller et al. 2018, "Real-Time Rendering", section 9.8). A constant
// exponent is the tutorials' and is left as they print it.
float lobe_scale(float exponent) { return shading.x >= 0.0 ? 1.0 : (exponent + 2.0) / 8.0; }

// Walter et al. 2007 (D), Heitz 2014 (correlated Smith visibility), as glTF 2.0, appendix B: pi D V / (alpha^2 / 2).
lane D_V_GGX(Receiver r, lane n_dot_h_2, lane n_dot_l) {
  lane k = n_dot_h_2 * (r.alpha2 - 1.0) + 1.0;
  lane l = r.n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - r.alpha2) + r.alpha2);
  return 1.0 / (k * k * max(l + n_dot_l * r.masking, 1e-7));
}

// Schlick 1994: f0 + (f90 - f0) times this. The cosine may come out a little above 1.
lane F_Schlick(lane v_dot_h) {
  lane x = max(1.0 - v_dot_h, 0.0), x2 = x * x;
  return x2 * x2 * x;
}

// The square of N.H, and |l + v|^2.
lane half_way_cosine_2(Receiver r, lane3 to_light, out lane length_2) {
  lane3 between = to_light + in_all_lanes(r.to_eye);
  length_2 = max(squares(between), 1e-20);  // 0 where light and eye are opposite
  lane along = max(dots(between, r.normal), 0.0);
  return along * along / length_2;
}

// `arriving`: what is left of the lights' colours. n_dot_l: >= 0.
Lighting reflected(Receiver r, lane3 to_light, lane n_dot_l, lane3 colour, lane arriving) {
  lane facing = arriving * n_dot_l;
#if SHADING_MODEL == MODEL_LAMBERT
  return Lighting(weighted_sum(colour, facing), vec3(0.0));
#elif SHADING_MODEL == MODEL_PHONG
  lane cosine = 2.0 * n_dot_l * r.n_dot_v - dots(to_light, r.to_eye);  // of the mirrored light and the eye
  return Lighting(weighted_sum(colour, facing), weighted_sum(colour, arriving * lobe(cosine, r.exponent)));
#else
  lane length_2, n_dot_h_2 = half_way_cosine_2(r, to_light, length_2);
#if SHADING_MODEL == MODEL_BLINN_PHONG
  return Lighting(weighted_sum(colour, facing), weighted_sum(colour, arriving * lobe(n_dot_h_2, 0.5 * r.exponent)));
#else
  // |l + v| is twice the cosine of the angle between either of them and what halves it.
  lane3 fresnel = in_all_lanes(r.f0) + times(F_Schlick(0.5 * sqrt(length_2)), r.grazing);
  return Lighting(weighted_sum(colour, scaled(in_all_lanes(vec3(1.0)) - fresnel, facing)),
                  weighted_sum(colour, scaled(fresnel, facing * D_V_GGX(r, n_dot_h_2, n_dot_l))));
#endif
#endif
}

// What the highlight of all lights is multiplied by.
vec3 highlight_scale(Receiver r) {
#if SHADING_MODEL == MODEL_GGX
  return vec3(0.5 * r.alpha2);
#else
  return r.f0 * lobe_scale(r.exponent);
#endif
}

// The sum of LIGHTS_AT_ONCE lights; highlights without highlight_scale(), which a sum of lights is given once.
Lighting shade(Receiver r, Light light) {
  lane3 to_light = light.position - in_all_lanes(r.position);
  lane d_2 = max(squares(to_light), 1e-12);  // a light on the surface must not divide by 0
  lane inverse_d = inversesqrt(d_2);
  to_light = scaled(to_light, inverse_d);
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) to_light = -light.direction;
#endif
  lane arriving = arriving_share(light, to_light, d_2 * inverse_d);
  lane n_dot_l = dots(to_light, r.normal);
#if !MISTAKE_SPECULAR_UNGATED
  arriving = if_less(lane(0.0), n_dot_l, arriving);  // turned away: no highlight either (`specular-ungated`)
#endif
#if SHADOWS
  arriving *= visibility(light, r.position, r.normal, to_light);
#endif
  return reflected(r, to_light, max(n_dot_l, 0.0), light.colour, arriving);
}
