#pragma once
// Which lights a surface point sees, by rays in double: of those that cast shadows under these settings.
#include <memory>

#include "renderer/options/settings.h"
#include "renderer/truth/height_fields.h"
#include "renderer/truth/ray_scene.h"
#include "renderer/truth/truth_shading.h"

namespace gbl {

class LightSight {
 public:
  // The scene must outlive it. heights: of these settings.
  LightSight(const Settings&, const Scene&, std::shared_ptr<const HeightFields> heights);

  bool shadows() const { return rays_ != nullptr; }               // is there any light that could be hidden?
  std::shared_ptr<const RayScene> rays() const { return rays_; }  // null without shadows
  // Is nothing solid between the surface and the light? A shading normal that faces the light does not help where the triangle
  // itself is turned away: then the object hides it. A sunken surface hides lights from itself, too; another one hides what is
  // behind its triangles. position: relative to the camera.
  bool sees(const TruthLight&, const glm::dvec3& position, const SeenSurface&) const;

 private:
  const bool suns_only_;
  const glm::dvec3 camera_;
  std::shared_ptr<const RayScene> rays_;
  std::shared_ptr<const HeightFields> heights_;
};

}  // namespace gbl
