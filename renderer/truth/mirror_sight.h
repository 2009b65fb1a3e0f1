#pragma once
// What a mirror shows at a point of it: one ray in double, and where it ends a surface with its textures. One texel's four
// neighbours of the largest level are read there; a frame reads mipmaps, so that the two differ where textures are fine.
#include <memory>
#include <optional>

#include "renderer/options/settings.h"
#include "renderer/truth/ray_scene.h"
#include "renderer/truth/truth_geometry.h"

namespace gbl {

// The texels of a surface that a ray meets.
SeenTexel texels_of(const SurfaceHit&, const Scene&, const Settings&);

class MirrorSight {
 public:
  // rays: of the scene, which must outlive it; null: it makes its own where it needs them.
  MirrorSight(const Settings&, const Scene&, std::shared_ptr<const RayScene> rays);

  bool mirrors() const { return rays_ != nullptr; }  // does any surface mirror others?
  bool mirrors(const SeenSurface&) const;
  // The ray that leaves the surface towards what it mirrors, relative to the camera.
  static Ray mirrored_ray(const TruthSurface&);
  // What it meets; empty: the background. A smooth object of flat triangles does not meet itself from within.
  std::optional<SeenTexel> seen(const Ray&, const SeenSurface& from) const;

 private:
  const Settings& settings_;
  const Scene& scene_;
  std::shared_ptr<const RayScene> rays_;
};

}  // namespace gbl
