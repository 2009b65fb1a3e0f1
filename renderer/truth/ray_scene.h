#pragma once
// A scene as rays see it: exact in double, quick by two levels of boxes, the instances and their meshes' triangles.
// Surfaces that blend hide nothing, and a masked one is cut out where its nearest texel says so.
#include <optional>
#include <vector>

#include "renderer/truth/bvh.h"
#include "renderer/truth/truth.h"

namespace gbl {

struct SurfaceHit {
  SeenSurface surface;
  double distance = 0;  // in lengths of the ray's direction
  glm::dvec3 weights{0};
  bool from_behind = false;  // its back is met
};

class RayScene {
 public:
  explicit RayScene(const Scene&);     // which must outlive it
  RayScene(const Scene&, int object);  // one of its objects alone, from 1, clear or not

  // The nearest within the part; world units, whatever side is met.
  std::optional<SurfaceHit> first_hit(const RayPart&) const;

  // Is anything in the way? `except`: the surface on which the ray begins, which cannot hide itself. from_below: it begins
  // below its object's surface, so that the backs of that object's triangles are ways out: where its plane ends, a neighbour's back is left.
  bool blocked(const RayPart&, const SeenSurface& except, bool from_below = false) const;

  // How far from its beginning a ray has to have come before a surface that it meets is another one than that on which it
  // begins, whose place is known to a few roundings of the largest coordinate. World units; `place` in the world.
  double least_distance(const glm::dvec3& place) const;

 private:
  struct Placed {
    const Mesh* mesh;
    const Bvh* triangles;
    const Material* material;
    glm::dmat4 object_from_world;
    bool mirrored;
    int object;  // as SeenSurface counts
  };
  void place(size_t instance);
  template <class Use>  // bool use(SurfaceHit, RayPart&): true: no more
  bool along(const RayPart&, Use) const;

  const Scene& scene_;
  double largest_coordinate_ = 0;
  std::vector<Bvh> meshes_;
  std::vector<Placed> placed_;
  std::vector<Bounds> boxes_;  // of placed_
  Bvh instances_;              // over placed_
};

}  // namespace gbl
