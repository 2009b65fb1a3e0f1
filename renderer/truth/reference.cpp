#include "renderer/truth/reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include "renderer/frame/frame_lights.h"
#include "renderer/light/lights.h"
#include "renderer/truth/ties.h"

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

Reference::Reference(const Settings& s, std::shared_ptr<const Scene> scene, std::vector<SeenTexel> texels,
                     StoreFn store)
    : settings_(s),
      scene_(std::move(scene)),
      texels_(std::move(texels)),
      geometry_(s, *scene_, std::move(store)),
      model_(s),
      sight_(s, *scene_),
      mirrors_(settings_, *scene_, sight_.rays()) {
  for (const Light& l : true_lights(s, *scene_)) lights_.push_back({l, l.position - s.camera.position});
  truth_.size = s.size;
  const size_t n = truth_.pixels();
  truth_.present.resize(n);
  truth_.roughness.resize(n);
  for (auto* list : {&truth_.lit, &truth_.diffuse, &truth_.specular, &truth_.albedo, &truth_.normal, &truth_.position})
    list->resize(n);
  if (sight_.shadows()) truth_.unshadowed.resize(n);
  if (mirrors_.mirrors()) truth_.mirrored_light.resize(n);
  lit_pairs_of_row_.resize(static_cast<size_t>(s.size.y));
}

void Reference::find_rivals(const std::atomic<bool>* cancel) {
  std::vector<SeenSurface> seen;
  for (const SeenTexel& t : texels_) seen.push_back(t.surface());
  truth_.rivals = rivals_of(settings_, *scene_, seen, cancel);
}

Reference::LightAt Reference::light_at(const TruthSurface& s, const SeenSurface& surface) const {
  LightAt out;
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

// Once: what is mirrored mirrors nothing.
Reference::Seen Reference::seen_along(const RayBundle& rays, const SeenSurface& from) const {
  const std::optional<SeenTexel> seen = mirrors_.seen(rays, from);
  if (!seen) return {background_radiance(settings_, rays.ray.direction)};
  const SurfaceAt at = geometry_.at(rays.ray, *seen);
  const LightAt light = light_at(at.surface, seen->surface());
  const glm::dvec3 of_lights = at.surface.albedo * light.sum.diffuse + light.sum.specular;
  return {settings_.ambient * at.ambient + at.emission + of_lights, of_lights, light.unshadowed};
}

void Reference::add_mirrored(size_t i, glm::ivec2 pixel, const SurfaceAt& at) {
  const TruthSurface& s = at.surface;
  const SeenSurface surface = texels_[i].surface();
  const auto add = [&](const glm::dvec3& share, const Seen& seen) {
    truth_.lit[i] += share * seen.all;
    truth_.mirrored_light[i] += share * seen.of_lights;
    if (sight_.shadows()) truth_.unshadowed[i] += share * seen.unshadowed;
  };
  const glm::dvec3 mirrored = fresnel(s.f0, std::max(glm::dot(s.normal, s.to_eye), 0.0));
  truth_.lit[i] -= settings_.ambient * at.gloss;
  add(mirrored, seen_along(mirrors_.mirrored_rays(s, pixel), surface));
  if (at.through == glm::dvec3(0)) return;
  const Through through = mirrors_.refracted_rays(s, surface);
  add((1.0 - mirrored) * at.through * through.share, seen_along(through.rays, surface));
}

void Reference::work_pixel(glm::ivec2 pixel) {
  const size_t i = static_cast<size_t>(pixel.y) * static_cast<size_t>(settings_.size.x) + static_cast<size_t>(pixel.x);
  const Ray ray = pixel_ray(settings_.camera, settings_.size, pixel);
  if (texels_[i].instance() < 0) {
    truth_.lit[i] = background_radiance(settings_, ray.direction);
    return;
  }
  const SurfaceAt at = geometry_.at(ray, texels_[i]);
  const TruthSurface& s = at.surface;
  const LightAt light = light_at(s, texels_[i].surface());
  const Reflected& sum = light.sum;
  truth_.present[i] = 1;
  if (sight_.shadows()) truth_.unshadowed[i] = light.unshadowed;
  truth_.diffuse[i] = sum.diffuse;
  truth_.specular[i] = sum.specular;
  truth_.albedo[i] = s.albedo;
  truth_.roughness[i] = s.roughness;
  truth_.normal[i] = s.normal;
  truth_.position[i] = s.position;
  truth_.lit[i] = settings_.ambient * at.ambient + at.emission + s.albedo * sum.diffuse + sum.specular;
  if (mirrors_.mirrors(texels_[i].surface())) add_mirrored(i, pixel, at);
  lit_pairs_of_row_[static_cast<size_t>(pixel.y)] += light.lit_pairs;
}

void Reference::work_row(int y) {
  lit_pairs_of_row_[static_cast<size_t>(y)] = 0;
  for (int x = 0; x < settings_.size.x; ++x) work_pixel({x, y});
}

bool Reference::run(int threads, const std::atomic<bool>* cancel) {
  const auto work = [&] {
    while (!(cancel && *cancel)) {
      const int y = next_row_++;
      if (y >= settings_.size.y) return;
      work_row(y);
      ++rows_done_;
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& t : others) t.join();
  return rows_done_ == settings_.size.y;
}

double Reference::progress() const { return double(rows_done_) / settings_.size.y; }

uint64_t Reference::lit_pairs() const {
  return std::accumulate(lit_pairs_of_row_.begin(), lit_pairs_of_row_.end(), uint64_t(0));
}

}  // namespace gbl
