#pragma once
// What a mirror shows at a point of it: one ray in double, and where it ends a surface with its textures, read as a sampler
// reads them.
#include <map>
#include <memory>
#include <optional>

#include "renderer/options/settings.h"
#include "renderer/truth/height_fields.h"
#include "renderer/truth/ray_scene.h"
#include "renderer/truth/texture_levels.h"
#include "renderer/truth/truth_geometry.h"

namespace gbl {

// A ray, and those of the pixels right and below, which say how much of a texture it sees; relative to the camera.
struct RayBundle {
  Ray ray, beside, below;
};

// What has come through an object, and the share of its light that did.
struct Through {
  RayBundle rays;
  double share = 1;
};

class MirrorSight {
 public:
  // rays: of the scene, which must outlive it; null: it makes its own where it needs them. heights: of these settings.
  MirrorSight(const Settings&, const Scene&, std::shared_ptr<const RayScene> rays,
              std::shared_ptr<const HeightFields> heights);

  bool mirrors() const { return rays_ != nullptr; }  // does any surface show others?
  bool mirrors(const SeenSurface&) const;
  // What leaves the surface, seen through this pixel (origin top left), towards what it mirrors.
  RayBundle mirrored_rays(const TruthSurface&, glm::ivec2 pixel) const;
  // Of a clear object: bent where it enters and where it leaves (Snell), reflected within where it cannot leave, at most so
  // often. What is reflected within where it could leave is lost.
  static constexpr int kMostWithin = 16;
  Through refracted_rays(const TruthSurface&, const SeenSurface&) const;
  // What it meets; empty: the background. Back faces of single-sided surfaces are not seen, as in a frame; nor is a smooth
  // object of flat triangles by itself from within.
  std::optional<SeenTexel> seen(const RayBundle&, const SeenSurface& from) const;

 private:
  glm::dvec3 normal_at(const SurfaceHit&) const;  // world, unit
  SeenTexel texels_of(const SurfaceHit&, const RayBundle&) const;
  // As wide as a pixel, around a ray that has come so far.
  RayBundle spread(const Ray&, double distance) const;

  const Settings& settings_;
  const Scene& scene_;
  std::shared_ptr<const RayScene> rays_;
  std::map<int, RayScene> within_;  // of each clear object
  std::optional<TextureLevels> textures_;
  std::shared_ptr<const HeightFields> heights_;
};

}  // namespace gbl
