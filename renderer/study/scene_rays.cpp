#include "renderer/study/scene_rays.h"

#include <cmath>

namespace gbl {
namespace {

struct Ray {
  glm::dvec3 origin, direction;
};

struct TriangleHit {
  double distance;
  bool from_behind;
};

// Moeller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
std::optional<TriangleHit> meet(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return {};
  const glm::dvec3 from_a = ray.origin - a, q = glm::cross(from_a, ab);
  const double u = glm::dot(from_a, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  const double distance = glm::dot(ac, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0)) return {};
  return TriangleHit{distance, determinant < 0};
}

}  // namespace

std::optional<RayHit> first_hit(const Scene& scene, const glm::dvec3& origin, const glm::dvec3& direction) {
  std::optional<RayHit> first;
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[static_cast<size_t>(instance.material)];
    if (material.alpha_mode == AlphaMode::blend) continue;
    const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
    const glm::dmat4 object_from_world = glm::inverse(instance.world_from_object);
    // Not normalised: distances stay those of the world. A mirrored instance shows its triangles' other side.
    const Ray ray{object_from_world * glm::dvec4(origin, 1), object_from_world * glm::dvec4(direction, 0)};
    const bool mirrored = glm::determinant(glm::dmat3(instance.world_from_object)) < 0;
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
    for (size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      const auto hit = meet(ray, corner(t), corner(t + 1), corner(t + 2));
      if (hit && (!first || hit->distance < first->distance))
        first = RayHit{hit->distance, hit->from_behind != mirrored && !material.double_sided};
    }
  }
  return first;
}

}  // namespace gbl
