// What one light does to one surface point: the arithmetic alone, in the subset common to GLSL and C++ (normal_encoding.glsl
// says how). So tests compare the very text with the reference, and `bench --micro` times it without a GPU.
// A light's colour is the radiance that a white Lambert surface sends back when it faces the light at unit
// attenuation, so no 1/pi appears below. A pixel asks this of many lights: what no light changes is worked out before the
// loop and after it, and there is no branch, since a group of pixels would take both of its sides.
#include "attenuation.glsl"

struct Lighting {
  vec3 diffuse;   // without albedo
  vec3 specular;
};

// A surface as lights find it.
struct Receiver {
  vec3 position;  // relative to the camera, world axes
  vec3 normal;    // world, unit
  vec3 to_eye;    // unit
  real n_dot_v;
  vec3 f0;
  real exponent;  // of (Blinn-)Phong's highlight
  // Of the microfacet model:
  vec3 grazing;  // what is added to f0 at grazing angles
  real alpha_2;  // roughness^4
  real masking;  // of V_SmithGGX: its root without the light
};

// At grazing angles all is reflected, but by what reflects less than 2 % when it is faced: there is no such material, a
// black metal stands for "reflects nothing" (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 3.1.1).
vec3 grazing_of(vec3 f0) { return vec3(min(real(50.0) * max(max(f0.x, f0.y), f0.z), real(1.0))) - f0; }

Receiver make_receiver(vec3 position, vec3 normal, vec3 to_eye, vec3 f0, real exponent, real roughness) {
  Receiver r;
  r.position = position;
  r.normal = normal;
  r.to_eye = to_eye;
  r.n_dot_v = dot(normal, to_eye);
  r.f0 = f0;
  r.exponent = exponent;
  r.grazing = grazing_of(f0);
  real alpha = max(roughness, real(0.045));  // part of the model: below it the lobe is narrower than a float resolves
  alpha = alpha * alpha;
  r.alpha_2 = alpha * alpha;
#if SHADING_MODEL == MODEL_GGX
  r.n_dot_v = max(r.n_dot_v, real(1e-4));
#endif
  r.masking = sqrt(r.n_dot_v * r.n_dot_v * (real(1.0) - r.alpha_2) + r.alpha_2);
  return r;
}

// The way from a surface to a light.
struct Way {
  lane3 direction;  // unit
  lane d;
};
Way way_between(vec3 surface, lane3 light) {
  Way way;
  lane3 all = light - in_all_lanes(surface);
  lane d_2 = max(squares(all), real(1e-12));  // a light on the surface must not divide by 0
  lane inverse_d = inversesqrt(d_2);
  way.direction = scaled(all, inverse_d);
  way.d = d_2 * inverse_d;
  return way;
}

// ---- highlights: radiance per unit of light, without N.L and highlight_scale() ---------------------------------

// cosine^exponent; 0 where the cosine is not above 0, but of exponent 0, which GLSL leaves open: the lab says 1, as C does.
lane lobe(lane cosine, real exponent) {
  real least = real(1e9) * (step(real(1e-30), exponent) - real(1.0));
  return if_less(lane(least), cosine, exp2(exponent * log2(max(cosine, real(1e-37)))));
}

// Walter et al. 2007 (D), Heitz 2014 (correlated Smith visibility), as glTF 2.0, appendix B: pi D V / (alpha^2 / 2).
lane D_V_GGX(Receiver r, lane n_dot_h_2, lane n_dot_l) {
  lane k = n_dot_h_2 * (r.alpha_2 - real(1.0)) + real(1.0);
  lane l = r.n_dot_v * sqrt(n_dot_l * n_dot_l * (real(1.0) - r.alpha_2) + r.alpha_2);
  return real(1.0) / (k * k * max(l + n_dot_l * r.masking, real(1e-7)));
}

// Schlick 1994: f0 + (f90 - f0) times this. The cosine may come out a little above 1.
lane F_Schlick(lane v_dot_h) {
  lane x = max(real(1.0) - v_dot_h, real(0.0));
  lane x_2 = x * x;
  return x_2 * x_2 * x;
}

// Of lights in these directions (unit), of which `arriving` is left. Highlights are without highlight_scale().
Lighting reflected(Receiver r, lane3 to_light, lane3 colour, lane arriving) {
  lane n_dot_l = dots(to_light, r.normal);
#if !MISTAKE_SPECULAR_UNGATED
  arriving = if_less(lane(0.0), n_dot_l, arriving);  // turned away: no highlight either (`specular-ungated`)
#endif
  lane lit_cosine = max(n_dot_l, real(0.0));
  lane facing = arriving * lit_cosine;
  Lighting sum;
  sum.diffuse = weighted_sum(colour, facing);
#if SHADING_MODEL == MODEL_LAMBERT
  sum.specular = vec3(0.0);
#elif SHADING_MODEL == MODEL_PHONG
  lane cosine = real(2.0) * n_dot_l * r.n_dot_v - dots(to_light, r.to_eye);  // of the mirrored light and the eye
  sum.specular = weighted_sum(colour, arriving * lobe(cosine, r.exponent));
#else
  lane3 between = to_light + in_all_lanes(r.to_eye);
  lane length_2 = max(squares(between), real(1e-20));  // 0 where light and eye are opposite
  lane along = max(dots(between, r.normal), real(0.0));
  lane n_dot_h_2 = along * along / length_2;
#if SHADING_MODEL == MODEL_BLINN_PHONG
  sum.specular = weighted_sum(colour, arriving * lobe(n_dot_h_2, real(0.5) * r.exponent));
#else
  // |l + v| is twice the cosine of the angle between either of them and what halves it.
  lane3 fresnel = in_all_lanes(r.f0) + times(F_Schlick(real(0.5) * sqrt(length_2)), r.grazing);
  sum.diffuse = weighted_sum(colour, scaled(in_all_lanes(vec3(1.0)) - fresnel, facing));
  sum.specular = weighted_sum(colour, scaled(fresnel, facing * D_V_GGX(r, n_dot_h_2, lit_cosine)));
#endif
#endif
  return sum;
}

// What the highlight of all lights is multiplied by. A lobe from roughness is normalised, so that a wet patch glitters and
// dry earth stays matte: (e + 2) / 8 keeps the reflected energy about constant (Akenine-Moeller et al. 2018, "Real-Time
// Rendering", section 9.8). A constant exponent is the tutorials' and is left as they print it.
vec3 highlight_scale(Receiver r, bool exponent_is_constant) {
#if SHADING_MODEL == MODEL_GGX
  return vec3(real(0.5) * r.alpha_2);
#else
  return exponent_is_constant ? r.f0 : r.f0 * ((r.exponent + real(2.0)) / real(8.0));
#endif
}
