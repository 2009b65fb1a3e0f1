#include "renderer/truth/scene_rays.h"

#include "renderer/truth/ray_triangle.h"

namespace gbl {
std::optional<RayHit> first_hit(const Scene& scene, const glm::dvec3& origin, const glm::dvec3& direction) {
  std::optional<RayHit> first;
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[static_cast<size_t>(instance.material)];
    if (material.alpha_mode == AlphaMode::blend) continue;
    const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
    const glm::dmat4 object_from_world = glm::inverse(instance.world_from_object);
    // Not normalised: distances stay those of the world. A mirrored instance shows its triangles' other side.
    const glm::dvec3 from = object_from_world * glm::dvec4(origin, 1),
                     along = object_from_world * glm::dvec4(direction, 0);
    const bool mirrored = glm::determinant(glm::dmat3(instance.world_from_object)) < 0;
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
    for (size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      const auto hit = meet(from, along, corner(t), corner(t + 1), corner(t + 2));
      if (hit && hit->distance > 0 && (!first || hit->distance < first->distance))
        first = RayHit{hit->distance, hit->from_behind != mirrored && !material.double_sided};
    }
  }
  return first;
}

}  // namespace gbl
