#pragma once
// All light that a surface sends to the eye, in double: of every light by brute force, and of what a smooth surface shows.
#include <memory>

#include "renderer/frame/frame_lights.h"
#include "renderer/truth/light_sight.h"
#include "renderer/truth/mirror_sight.h"
#include "renderer/truth/truth_geometry.h"

namespace gbl {

// The lights as they are meant: lights_of() without any mistake.
std::vector<Light> true_lights(const Settings&, const Scene&);

// Radiance where no surface is seen along this direction.
glm::dvec3 background_radiance(const Settings&, const glm::dvec3& direction);

class SurfaceLight {
 public:
  SurfaceLight(const Settings&, const Scene&);  // which must outlive it

  bool shadows() const { return sight_.shadows(); }
  bool mirrors() const { return mirrors_.mirrors(); }

  struct OfLights {
    Reflected sum;
    glm::dvec3 unshadowed{0};  // radiance if nothing hid a light; 0 without shadows
    uint64_t lit_pairs = 0;    // lights that reach the surface, whatever it faces
  };
  OfLights of_lights(const TruthSurface&, const SeenSurface&) const;

  // What a surface mirrors and lets through, less the ambient gloss that stood for it: radiance, the lights' part of it, and
  // that if nothing hid them. All 0 where it is no mirror. Once: what is mirrored mirrors nothing.
  struct Mirrored {
    glm::dvec3 all{0}, of_lights{0}, unshadowed{0};
  };
  Mirrored mirrored(const SurfaceAt&, const SeenSurface&, glm::ivec2 pixel) const;

 private:
  Mirrored seen_along(const RayBundle&, const SeenSurface& from) const;

  const Settings& settings_;
  TruthGeometry geometry_;  // of what is mirrored: as it is, not as a layout would store it; without mirrors
  ShadingModelOf model_;
  LightSight sight_;
  MirrorSight mirrors_;
  std::vector<TruthLight> lights_;
};

}  // namespace gbl
