#include "renderer/truth/light_sight.h"

namespace gbl {

LightSight::LightSight(const Settings& s, const Scene& scene, std::shared_ptr<const HeightFields> heights)
    : suns_only_(s.shadows == Shadows::sun), camera_(s.camera.position), heights_(std::move(heights)) {
  if (s.shadows != Shadows::off) rays_ = std::make_shared<const RayScene>(scene);
}

bool LightSight::sees(const TruthLight& l, const glm::dvec3& position, const SeenSurface& surface) const {
  const bool sun = l.light.kind == LightKind::directional;
  if (!rays_ || (suns_only_ && !sun)) return true;
  const auto towards = [&](const glm::dvec3& from) { return sun ? -l.light.direction : l.position - from; };
  const std::optional<HeightFields::Way> way = heights_->way_out(position, towards(position), surface);
  if (!way) return false;
  const glm::dvec3 place = way->out + camera_, to_light = towards(way->out);
  const double least = rays_->least_distance(place) / glm::length(to_light);
  return !rays_->blocked({place, to_light, least, sun ? kEndless : 1 - least}, surface, way->from_below);
}

}  // namespace gbl
