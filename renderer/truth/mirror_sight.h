#pragma once
// What a mirror shows at a point of it: one ray in double, and where it ends a surface with its textures. One texel's four
// neighbours of the largest level are read there; a frame reads mipmaps, so that the two differ where textures are fine.
#include <map>
#include <memory>
#include <optional>

#include "renderer/options/settings.h"
#include "renderer/truth/ray_scene.h"
#include "renderer/truth/truth_geometry.h"

namespace gbl {

// The texels of a surface that a ray meets.
SeenTexel texels_of(const SurfaceHit&, const Scene&, const Settings&);

// A ray that has come through an object, relative to the camera, and the share of its light that did.
struct Through {
  Ray ray;
  double share = 1;
};

class MirrorSight {
 public:
  // rays: of the scene, which must outlive it; null: it makes its own where it needs them.
  MirrorSight(const Settings&, const Scene&, std::shared_ptr<const RayScene> rays);

  bool mirrors() const { return rays_ != nullptr; }  // does any surface show others?
  bool mirrors(const SeenSurface&) const;
  // The ray that leaves the surface towards what it mirrors, relative to the camera.
  static Ray mirrored_ray(const TruthSurface&);
  // Of a clear object: bent where it enters and where it leaves (Snell), reflected within where it cannot leave, at most so
  // often. What is reflected within where it could leave is lost.
  static constexpr int kMostWithin = 16;
  Through refracted_ray(const TruthSurface&, const SeenSurface&) const;
  // What it meets; empty: the background. A smooth object of flat triangles does not meet itself from within.
  std::optional<SeenTexel> seen(const Ray&, const SeenSurface& from) const;

 private:
  glm::dvec3 normal_at(const SurfaceHit&) const;  // world, unit

  const Settings& settings_;
  const Scene& scene_;
  std::shared_ptr<const RayScene> rays_;
  std::map<int, RayScene> within_;  // of each clear object
};

}  // namespace gbl
