#include "renderer/truth/light_sight.h"

namespace gbl {

LightSight::LightSight(const Settings& s, const Scene& scene)
    : suns_only_(s.shadows == Shadows::sun), camera_(s.camera.position) {
  if (s.shadows != Shadows::off) rays_ = std::make_shared<const RayScene>(scene);
}

bool LightSight::sees(const TruthLight& l, const glm::dvec3& position, const SeenSurface& surface) const {
  const bool sun = l.light.kind == LightKind::directional;
  if (!rays_ || (suns_only_ && !sun)) return true;
  const glm::dvec3 place = position + camera_;
  const glm::dvec3 to_light = sun ? -l.light.direction : l.position - position;
  const double least = rays_->least_distance(place) / glm::length(to_light);
  return !rays_->blocked({place, to_light, least, sun ? kEndless : 1 - least}, surface);
}

}  // namespace gbl
