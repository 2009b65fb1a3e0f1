#include "renderer/truth/surface_light.h"

#include <algorithm>
#include <cmath>

namespace gbl {

std::vector<Light> true_lights(const Settings& s, const Scene& scene) {
  Settings meant = s;
  meant.mistakes.clear();
  return lights_of(meant, scene);
}

glm::dvec3 background_radiance(const Settings& s, const glm::dvec3& direction) {
  switch (s.background.fill) {
    case BackgroundFill::black: return glm::dvec3(0);
    case BackgroundFill::grey: return glm::dvec3(0.2);
    case BackgroundFill::colour: return s.background.colour;
    case BackgroundFill::sky: break;
  }
  // A clear day: horizon to zenith; below the horizon the ground's haze.
  const double height = glm::normalize(direction).y;
  if (height < 0)
    return glm::mix(glm::dvec3(0.42, 0.45, 0.47), glm::dvec3(0.16, 0.15, 0.14), std::min(-4 * height, 1.0));
  return glm::mix(glm::dvec3(0.62, 0.74, 0.86), glm::dvec3(0.10, 0.24, 0.55), std::pow(height, 0.6));
}

// What is mirrored is seen as in a frame without mirrors: what is clear is drawn as it is there, too.
static Settings without_reflections(Settings s) {
  s.reflections = Reflections::off;
  return s;
}

SurfaceLight::SurfaceLight(const Settings& s, const Scene& scene)
    : settings_(s),
      geometry_(without_reflections(s), scene),
      model_(s),
      sight_(s, scene, geometry_.heights()),
      mirrors_(s, scene, sight_.rays(), geometry_.heights()) {
  for (const Light& l : true_lights(s, scene)) lights_.push_back({l, l.position - s.camera.position});
}

SurfaceLight::OfLights SurfaceLight::of_lights(const TruthSurface& s, const SeenSurface& surface) const {
  OfLights out;
  for (const TruthLight& light : lights_) {
    if (reaches(light, s.position)) ++out.lit_pairs;
    const Reflected one = reflected(model_, s, light);
    if (sight_.shadows()) out.unshadowed += s.albedo * one.diffuse + one.specular;
    if (one.nothing() || !sight_.sees(light, s.position, surface)) continue;
    out.sum.diffuse += one.diffuse;
    out.sum.specular += one.specular;
  }
  return out;
}

SurfaceLight::Mirrored SurfaceLight::seen_along(const RayBundle& rays, const SeenSurface& from) const {
  const std::optional<SeenTexel> seen = mirrors_.seen(rays, from);
  if (!seen) return {background_radiance(settings_, rays.ray.direction)};
  const SurfaceAt at = geometry_.at(rays.ray, *seen);
  const OfLights light = of_lights(at.surface, seen->surface());
  const glm::dvec3 lit = at.surface.albedo * light.sum.diffuse + light.sum.specular;
  return {settings_.ambient * at.ambient + at.emission + lit, lit, light.unshadowed};
}

SurfaceLight::Mirrored SurfaceLight::mirrored(const SurfaceAt& at, const SeenSurface& surface, glm::ivec2 pixel) const {
  if (!mirrors_.mirrors(surface)) return {};
  Mirrored out{-settings_.ambient * at.gloss};
  const auto add = [&](const glm::dvec3& share, const Mirrored& seen) {
    out.all += share * seen.all;
    out.of_lights += share * seen.of_lights;
    out.unshadowed += share * seen.unshadowed;
  };
  const TruthSurface& s = at.surface;
  const glm::dvec3 share = fresnel(s.f0, std::max(glm::dot(s.normal, s.to_eye), 0.0));
  add(share, seen_along(mirrors_.mirrored_rays(s, pixel), surface));
  if (at.through == glm::dvec3(0)) return out;
  const Through through = mirrors_.refracted_rays(s, surface);
  add((1.0 - share) * at.through * through.share, seen_along(through.rays, surface));
  return out;
}

}  // namespace gbl
