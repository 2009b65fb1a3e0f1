#include "renderer/scene/scene.h"

namespace gbl {
namespace {

constexpr uint64_t kMostPoints = 20'000'000;  // visited one by one: a fraction of a second

}  // namespace

void visit_points(const Scene& scene, const std::function<void(const glm::dvec3&)>& visit) {
  uint64_t points = 0;
  for (const Instance& instance : scene.instances)
    points += scene.meshes[static_cast<size_t>(instance.mesh)].vertices.size();
  const auto visit_placed = [&](const Instance& instance, const glm::dvec3& p) {
    visit(glm::dvec3(instance.world_from_object * glm::dvec4(p, 1)));
  };
  if (points <= kMostPoints) {
    for (const Instance& instance : scene.instances)
      for (const Vertex& v : scene.meshes[static_cast<size_t>(instance.mesh)].vertices)
        visit_placed(instance, glm::dvec3(v.position));
    return;
  }
  std::vector<std::array<glm::dvec3, 8>> boxes;
  for (const Mesh& mesh : scene.meshes) boxes.push_back(corners_of(bounds_of(mesh)));
  for (const Instance& instance : scene.instances)
    for (const glm::dvec3& p : boxes[static_cast<size_t>(instance.mesh)]) visit_placed(instance, p);
}

std::array<glm::dvec3, 8> corners_of(const Bounds& box) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i)
    corners[i] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
  return corners;
}

Bounds bounds_of(const Mesh& mesh) {
  Bounds b = kNoBounds;
  for (const Vertex& v : mesh.vertices) include(b, glm::dvec3(v.position));
  return b;
}

Bounds bounds_of(const Scene& scene) {
  Bounds b = kNoBounds;
  visit_points(scene, [&](const glm::dvec3& p) { include(b, p); });
  return b.min.x <= b.max.x ? b : Bounds{};
}

}  // namespace gbl
