#include "renderer/scene/scene.h"

#include <limits>

namespace gbl {

Bounds bounds_of(const Scene& scene) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  Bounds b{glm::dvec3(kInf), glm::dvec3(-kInf)};
  for (const Instance& instance : scene.instances)
    for (const Vertex& v : scene.meshes[instance.mesh].vertices) {
      const glm::dvec3 p(instance.world_from_object * glm::dvec4(glm::dvec3(v.position), 1));
      b.min = glm::min(b.min, p);
      b.max = glm::max(b.max, p);
    }
  return b.min.x <= b.max.x ? b : Bounds{};
}

}  // namespace gbl
