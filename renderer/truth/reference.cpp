#include "renderer/truth/reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/base/stopwatch.h"
#include "renderer/base/threads.h"
#include "renderer/truth/ties.h"

namespace gbl {

Reference::Reference(const Settings& s, std::shared_ptr<const Scene> scene, std::vector<SeenTexel> texels,
                     StoreFn store)
    : settings_(s),
      scene_(std::move(scene)),
      texels_(std::move(texels)),
      geometry_(s, *scene_, std::move(store)),
      light_(settings_, *scene_) {
  truth_.size = s.size;
  const size_t n = truth_.pixels();
  truth_.present.resize(n);
  truth_.roughness.resize(n);
  for (auto* list : {&truth_.lit, &truth_.diffuse, &truth_.specular, &truth_.albedo, &truth_.normal, &truth_.position})
    list->resize(n);
  if (light_.shadows()) truth_.unshadowed.resize(n);
  if (light_.mirrors()) truth_.mirrored_light.resize(n);
  lit_pairs_of_row_.resize(static_cast<size_t>(s.size.y));
}

bool Reference::find_rivals(const std::atomic<bool>* cancel, double at_most_ms) {
  const Stopwatch watch;
  std::vector<SeenSurface> seen;
  for (const SeenTexel& t : texels_) seen.push_back(t.surface());
  while (next_rival_place_ < kRivalPlaces) {
    if (cancel && *cancel) return false;
    add_rivals(next_rival_place_++, settings_, *scene_, seen, truth_.rivals);
    if (watch.ms() >= at_most_ms) return false;
  }
  put_in_order(truth_.rivals);
  return true;
}

void Reference::add_mirrored(size_t i, const SurfaceLight::Mirrored& mirrored) {
  truth_.lit[i] += mirrored.all;
  truth_.mirrored_light[i] = mirrored.of_lights;
  if (light_.shadows()) truth_.unshadowed[i] += mirrored.unshadowed;
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
  const SurfaceLight::OfLights light = light_.of_lights(s, texels_[i].surface());
  const Reflected& sum = light.sum;
  truth_.present[i] = 1;
  if (light_.shadows()) truth_.unshadowed[i] = light.unshadowed;
  truth_.diffuse[i] = sum.diffuse;
  truth_.specular[i] = sum.specular;
  truth_.albedo[i] = s.albedo;
  truth_.roughness[i] = s.roughness;
  truth_.normal[i] = s.normal;
  truth_.position[i] = s.position;
  truth_.lit[i] = settings_.ambient * at.ambient + at.emission + s.albedo * sum.diffuse + sum.specular;
  if (light_.mirrors()) add_mirrored(i, light_.mirrored(at, texels_[i].surface(), pixel));
  lit_pairs_of_row_[static_cast<size_t>(pixel.y)] += light.lit_pairs;
}

void Reference::work_row(int y) {
  lit_pairs_of_row_[static_cast<size_t>(y)] = 0;
  for (int x = 0; x < settings_.size.x; ++x) work_pixel({x, y});
}

bool Reference::run(int threads, const std::atomic<bool>* cancel, double at_most_ms) {
  const Stopwatch watch;
  const auto work = [&](int) {
    while (!(cancel && *cancel)) {
      const int y = next_row_++;
      if (y >= settings_.size.y) return;
      work_row(y);
      ++rows_done_;
      if (watch.ms() >= at_most_ms) return;
    }
  };
  on_threads(threads, work);
  return rows_done_ == settings_.size.y;
}

double Reference::progress() const { return double(rows_done_) / settings_.size.y; }

uint64_t Reference::lit_pairs() const {
  return std::accumulate(lit_pairs_of_row_.begin(), lit_pairs_of_row_.end(), uint64_t(0));
}

}  // namespace gbl
