#pragma once
// Height maps in double: where a line of sight ends below a triangle, and whether light finds the way out again. Over each
// triangle the map spans a field of bilinear patches between its texels' centres, in the triangle's plane, which goes on
// beyond its edges. A line crosses a patch as a parabola, so that the first crossing is found in closed form, patch by patch.
#include <atomic>
#include <optional>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/truth/truth_geometry.h"

namespace gbl {

// Where a line of sight ends.
struct Sunk {
  glm::dvec3 by{0};        // from where it meets the triangle's plane, world units
  glm::dvec2 uv_moved{0};  // of the first set of texture coordinates
};

class HeightFields {
 public:
  HeightFields(const Settings&, const Scene&);  // which must outlive it

  // A line of sight, relative to the camera, to a triangle with a height map. Nothing where its back is seen, or along it.
  Sunk sunk(const Ray&, const SeenSurface&) const;
  // From such a place towards a light: where it leaves the triangle's plane, and whether it came from below it. Empty: the
  // surface itself is in the way. Places relative to the camera.
  struct Way {
    glm::dvec3 out{0};
    bool from_below = false;
  };
  std::optional<Way> way_out(const glm::dvec3& place, const glm::dvec3& to_light, const SeenSurface&) const;

 private:
  struct Map {
    glm::ivec2 size{0};
    std::vector<double> depths;  // 0 the plane … 1 the lowest place
    double depth = 0;            // of the lowest place, world units
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;

    double at(glm::ivec2 texel) const;
    double at(const glm::dvec2& texel) const;  // between the centres of four; 0, 0: the first texel's centre
  };
  // Of a triangle, relative to the camera.
  struct Plane {
    glm::dvec3 corner, normal;    // unit, to the front
    glm::dvec2 uv;                // at the corner
    glm::dvec3 along_u, along_v;  // how u and v change: du = dot(along_u, dp)
    glm::dvec2 uv_by(const glm::dvec3& dp) const { return {glm::dot(along_u, dp), glm::dot(along_v, dp)}; }
  };
  const Map* map_of(const SeenSurface&) const;
  Plane plane_of(const SeenSurface&) const;

  const Scene& scene_;
  const glm::dvec3 camera_;
  std::vector<std::optional<Map>> maps_;  // of each material; empty: no surface is sunk
};

// Of every texel that is seen: how far texture coordinates move (xy), for the pass that samples textures there. When cancelled
// the rest is 0.
std::vector<glm::vec4> uvs_moved(const HeightFields&, const Settings&, const std::vector<SeenTexel>&, int threads,
                                 const std::atomic<bool>* cancel = nullptr);

}  // namespace gbl
