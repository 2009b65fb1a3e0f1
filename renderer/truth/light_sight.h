#pragma once
// Which lights a surface point sees, by rays in double: of those that cast shadows under these settings.
#include <memory>

#include "renderer/options/settings.h"
#include "renderer/truth/ray_scene.h"
#include "renderer/truth/truth_shading.h"

namespace gbl {

class LightSight {
 public:
  LightSight(const Settings&, const Scene&);  // the scene must outlive it

  bool shadows() const { return rays_ != nullptr; }               // is there any light that could be hidden?
  std::shared_ptr<const RayScene> rays() const { return rays_; }  // null without shadows
  // Is nothing solid between the surface and the light? A shading normal that faces the light does not help where the
  // triangle itself is turned away: then the object hides it. position: relative to the camera.
  bool sees(const TruthLight&, const glm::dvec3& position, const SeenSurface&) const;

 private:
  const bool suns_only_;
  const glm::dvec3 camera_;
  std::shared_ptr<const RayScene> rays_;
};

}  // namespace gbl
