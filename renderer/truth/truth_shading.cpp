#include "renderer/truth/truth_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/light/attenuation.h"

namespace gbl {
namespace {

// Nearer than this a light on the surface would divide by 0, world units.
constexpr double kNearest = 1e-6;
// Below this perceptual roughness the lobe is narrower than a float resolves; the clamp is part of the model.
constexpr double kSmoothest = 0.045;

double square(double x) { return x * x; }
double fifth_power(double x) { return square(square(x)) * x; }

double smooth_window(double x) { return square(std::clamp(1 - square(square(x)), 0.0, 1.0)); }

// Of what a light sends towards a point at this distance and in this direction, the share that arrives.
double strength(const ShadingModelOf& m, const Light& l, double distance, const glm::dvec3& from_light) {
  double share = l.coefficients == glm::dvec3(0)
                     ? attenuation_at(m.attenuation, distance, l.profile_range)
                     : 1 / (l.coefficients.x + distance * (l.coefficients.y + distance * l.coefficients.z));
  if (l.kind == LightKind::spot) {
    const double cosine = glm::dot(from_light, l.direction);
    // KHR_lights_punctual, section "Inner and Outer Cone Angles"; under cos-power inner_cos holds the exponent.
    const double edge = m.attenuation == Attenuation::gltf ? 1e-3 : 1e-4;
    share *= m.spot == LightSpot::cos_power
                 ? std::pow(std::max(cosine, 0.0), l.inner_cos)
                 : square(std::clamp((cosine - l.outer_cos) / std::max(l.inner_cos - l.outer_cos, edge), 0.0, 1.0));
  }
  return m.windowed_range ? share * smooth_window(distance / l.range) : share;
}

// Phong 1975 and Blinn 1977. A lobe from roughness is normalised by (e + 2) / 8 (Akenine-Moeller et al. 2018,
// "Real-Time Rendering", section 9.8); a constant exponent stays as the tutorials print it.
double lobe(const ShadingModelOf& m, double cosine, double exponent) {
  const double scale = m.constant_exponent >= 0 ? 1 : (exponent + 2) / 8;
  return scale * (exponent > 0 ? std::pow(std::max(cosine, 0.0), exponent) : 1);
}

// Walter et al. 2007 (GGX), Heitz 2014 (height-correlated Smith), Schlick 1994 (Fresnel).
Reflected ggx(const TruthSurface& s, const glm::dvec3& to_light, double n_dot_l) {
  const glm::dvec3 half = glm::normalize(to_light + s.to_eye);
  const double alpha2 = square(square(std::max(s.roughness, kSmoothest)));
  const double n_dot_h = std::max(glm::dot(s.normal, half), 0.0);
  const double n_dot_v = std::max(glm::dot(s.normal, s.to_eye), 1e-4);
  const double distribution = alpha2 / (glm::pi<double>() * square(square(n_dot_h) * (alpha2 - 1) + 1));
  const double masking = n_dot_l * std::sqrt(square(n_dot_v) * (1 - alpha2) + alpha2) +
                         n_dot_v * std::sqrt(square(n_dot_l) * (1 - alpha2) + alpha2);
  const double visibility = 0.5 / std::max(masking, 1e-7);
  const glm::dvec3 mirrored = fresnel(s.f0, std::max(glm::dot(s.to_eye, half), 0.0));
  return {n_dot_l * (1.0 - mirrored), n_dot_l * glm::pi<double>() * distribution * visibility * mirrored};
}

Reflected reflected_of_unit(const ShadingModelOf& m, const TruthSurface& s, const glm::dvec3& to_light,
                            double n_dot_l) {
  switch (m.model) {
    case ShadingModel::lambert: return {glm::dvec3(n_dot_l), glm::dvec3(0)};
    case ShadingModel::phong: {
      const glm::dvec3 mirrored = 2 * n_dot_l * s.normal - to_light;
      return {glm::dvec3(n_dot_l), s.f0 * lobe(m, glm::dot(mirrored, s.to_eye), s.exponent)};
    }
    case ShadingModel::blinn_phong: {
      const glm::dvec3 half = glm::normalize(to_light + s.to_eye);
      return {glm::dvec3(n_dot_l), s.f0 * lobe(m, glm::dot(s.normal, half), s.exponent)};
    }
    case ShadingModel::ggx: return ggx(s, to_light, n_dot_l);
  }
  return {};
}

}  // namespace

ShadingModelOf::ShadingModelOf(const Settings& s)
    : model(s.shading.model),
      attenuation(s.attenuation),
      spot(s.lights.spot),
      windowed_range(s.range.kind == RangeKind::windowed),
      constant_exponent(s.shading.exponent),
      dielectric_f0(s.shading.model == ShadingModel::ggx ? kCommonReflectance : s.shading.specular) {}

double ShadingModelOf::exponent(double roughness) const {
  if (constant_exponent >= 0) return constant_exponent;
  return std::clamp(2 / std::max(square(square(roughness)), 1e-8) - 2, 1.0, 8192.0);
}

glm::dvec3 fresnel(const glm::dvec3& f0, double cosine) {
  const double grazing = fifth_power(1 - cosine);
  // Below 2 % at normal incidence nothing shines at grazing angles either (Lagarde and de Rousiers 2014, 3.1.1).
  const double f90 = std::min(50 * std::max({f0.x, f0.y, f0.z}), 1.0);
  return f0 + (f90 - f0) * grazing;
}

bool reaches(const TruthLight& l, const glm::dvec3& position) {
  if (l.light.kind == LightKind::directional) return true;
  const glm::dvec3 from_light = position - l.position;
  const double distance2 = glm::dot(from_light, from_light);
  if (!(distance2 < square(l.light.range))) return false;
  return l.light.kind == LightKind::point ||
         glm::dot(from_light, l.light.direction) > l.light.outer_cos * std::sqrt(distance2);
}

double arriving_share(const ShadingModelOf& m, const TruthLight& l, const glm::dvec3& position) {
  if (l.light.kind == LightKind::directional) return 1;
  const glm::dvec3 from_light = position - l.position;
  const double distance = glm::length(from_light);
  return distance < l.light.range ? strength(m, l.light, distance, from_light / std::max(distance, kNearest)) : 0;
}

Reflected reflected(const ShadingModelOf& m, const TruthSurface& s, const TruthLight& l) {
  glm::dvec3 to_light;
  double share = 1;
  if (s.unlit) return {};
  if (l.light.kind == LightKind::directional) {
    to_light = -l.light.direction;
  } else {
    to_light = l.position - s.position;
    const double distance2 = glm::dot(to_light, to_light);
    if (distance2 >= square(l.light.range)) return {};
    if (glm::dot(s.normal, to_light) <= 0) return {};
    const double distance = std::sqrt(distance2);
    to_light /= std::max(distance, kNearest);
    share = strength(m, l.light, distance, -to_light);
  }
  const double n_dot_l = glm::dot(s.normal, to_light);
  if (!(n_dot_l > 0) || share == 0) return {};
  const Reflected r = reflected_of_unit(m, s, to_light, n_dot_l);
  return {share * l.light.colour * r.diffuse, share * l.light.colour * r.specular};
}

}  // namespace gbl
