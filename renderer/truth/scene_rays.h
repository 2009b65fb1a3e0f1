#pragma once
// What a ray meets first in a scene: brute force over all triangles, in double. For a few rays, not for pictures.
#include <optional>

#include "renderer/scene/scene.h"

namespace gbl {

struct RayHit {
  double distance = 0;       // in lengths of the direction
  bool from_behind = false;  // the back of a triangle whose material is not double-sided
};

// Surfaces that blend are passed through: they hide nothing. Empty: nothing is met.
std::optional<RayHit> first_hit(const Scene&, const glm::dvec3& origin, const glm::dvec3& direction);

}  // namespace gbl
