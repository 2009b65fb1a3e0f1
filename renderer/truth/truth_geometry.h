#pragma once
// From "this triangle is seen through this pixel" to a surface point, in double.
#include <functional>
#include <memory>

#include "renderer/truth/truth.h"
#include "renderer/truth/truth_shading.h"

namespace gbl {

// What the GPU says of one pixel: which triangle is seen, and what its textures hold there. Sampling is taken as it
// is, so that no layout is blamed for it. Each is one texel of a float picture.
struct SeenTexel {
  glm::vec4 seen{0};      // instance from 1 (0: no surface), triangle of its mesh from 0, roughness and metal texels
  glm::vec4 base{1};      // base colour texel, linear (as-tutorial: the code), and its alpha
  glm::vec4 normal{0};    // normal map's texel, 0..1, and the occlusion texel
  glm::vec4 emission{0};  // emission texel
  glm::vec4 specular{1};  // specular colour's texel, linear (as-tutorial: the code), and the texel of its weight

  int instance() const { return static_cast<int>(seen.x) - 1; }
  int triangle() const { return static_cast<int>(seen.y); }
  SeenSurface surface() const { return {instance() + 1, triangle()}; }
};
inline constexpr int kSeenTexels = sizeof(SeenTexel) / sizeof(glm::vec4);

// A line of sight: origin relative to the camera, direction not normalised.
struct Ray {
  glm::dvec3 origin{0}, direction{0, 0, -1};
};
// Through the centre of a pixel (origin top left).
Ray pixel_ray(const Camera&, glm::ivec2 size, glm::ivec2 pixel);

// Weights of a triangle's corners where the ray meets its plane; a point beside the triangle is moved to its border
// (the rasteriser snaps corners to 1/256 of a pixel, so a pixel may see a triangle that its ray just misses).
glm::dvec3 barycentrics(const Ray&, const glm::dvec3 (&corners)[3]);

// What a G-buffer has to store of a surface point besides its position.
struct TruthMaterial {
  glm::dvec3 normal{0};  // world, unit
  glm::dvec3 base{0};    // linear
  double metal = 0, roughness = 1, occlusion = 1;
  glm::dvec3 dielectric{kCommonReflectance};  // what it reflects where it is no metal
  glm::dvec3 emission{0};                     // radiance
  bool unlit = false;
  glm::dvec3 through{0};  // share of light that goes through
};

struct SurfaceAt {
  TruthSurface surface;
  glm::dvec3 ambient{0};   // share of ambient light that is sent back
  glm::dvec3 gloss{0};     // of that, what a mirror shows instead
  glm::dvec3 through{0};   // share of light that goes through, where it is not reflected
  glm::dvec3 emission{0};  // radiance
};

class HeightFields;

// What a layout would make of a material: to ask in double how many bits a picture needs.
using StoreFn = std::function<void(TruthMaterial&)>;

class TruthGeometry {
 public:
  TruthGeometry(const Settings&, const Scene&, StoreFn store = {});
  SurfaceAt at(const Ray&, const SeenTexel&) const;
  std::shared_ptr<const HeightFields> heights() const { return heights_; }

 private:
  // Of an instance, made once: everything relative to the camera.
  struct Placed {
    glm::dmat4 relative_from_object{1};
    glm::dmat3 normals{1};
    bool mirrored = false;
  };
  glm::dvec3 shading_normal(const Placed&, const Material&, const Vertex* const (&corners)[3],
                            const glm::dvec3& weights, bool front, const glm::vec4& texel) const;

  TruthMaterial material_at(const Material&, const Vertex* const (&corners)[3], const glm::dvec3& weights,
                            const SeenTexel&) const;

  const Settings settings_;
  const Scene& scene_;
  const ShadingModelOf model_;
  const StoreFn store_;
  const std::shared_ptr<const HeightFields> heights_;
  std::vector<Placed> placed_;
};

}  // namespace gbl
