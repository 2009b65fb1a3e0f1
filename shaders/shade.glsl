// What one light does to one surface point. Every lighting method calls this and nothing else.
#include "surface.glsl"
#include "lights.glsl"

struct Lighting {
  vec3 diffuse;   // without albedo
  vec3 specular;
};

float attenuation(float distance, float range) {
  return 1.0 - clamp(distance / range, 0.0, 1.0);  // linear: 0 at and beyond the range
}

// Blinn-Phong exponent. 2/alpha^2 - 2 with alpha = roughness^2 matches the lobe of a microfacet surface
// (Walter et al. 2007, "Microfacet models for refraction through rough surfaces", section 5.2).
float exponent_of(float roughness) {
  if (shading.x >= 0.0) return shading.x;
  float alpha = roughness * roughness;
  return clamp(2.0 / max(alpha * alpha, 1e-8) - 2.0, 1.0, 8192.0);
}

// A lobe from roughness is normalised, so that a wet patch glitters and dry earth stays matte: (e + 2) / 8 keeps the
// reflected energy about constant (Akenine-Moeller et al. 2018, "Real-Time Rendering", section 9.8). A constant
// exponent is the tutorials' and is left as they print it.
float lobe_scale(float exponent) { return shading.x >= 0.0 ? 1.0 : (exponent + 2.0) / 8.0; }

Lighting shade(Surface s, Light light) {
  Lighting none = Lighting(vec3(0.0), vec3(0.0));
  vec3 to_light = light.position - s.position;
  float distance = length(to_light);
  if (distance >= light.range) return none;
  to_light /= max(distance, 1e-6);  // a light on the surface must not divide by 0
  float n_dot_l = dot(s.normal, to_light);
  if (!(n_dot_l > 0.0)) return none;  // turned away: no diffuse, and no highlight either (`specular-ungated`)
  vec3 to_eye = ray_forward.w > 0.5 ? -ray_forward.xyz : -normalize(s.position);
  vec3 half_way = normalize(to_light + to_eye);
  float n_dot_h = max(dot(s.normal, half_way), 0.0);
  vec3 arriving = light.colour * attenuation(distance, light.range);
  float exponent = exponent_of(s.roughness);
  return Lighting(arriving * n_dot_l, arriving * (shading.y * lobe_scale(exponent) * pow(n_dot_h, exponent)));
}
