#include "renderer/scene/mesh_parts.h"

#include <algorithm>
#include <numeric>

namespace gbl {
namespace {

constexpr size_t kFewTriangles = 4 * kPartTriangles;

// Ten bits of a number, two zeros between each and the next.
uint32_t spread_out(uint32_t x) {
  x = (x | (x << 16)) & 0x030000ff;
  x = (x | (x << 8)) & 0x0300f00f;
  x = (x | (x << 4)) & 0x030c30c3;
  return (x | (x << 2)) & 0x09249249;
}

// Where a point lies along a curve that stays in each eighth of a box before it goes on to the next (Morton 1966, "A Computer
// Oriented Geodetic Data Base"). Cells are cubes: a landscape is cut into fields, not into layers.
uint32_t place_along_curve(const glm::dvec3& point, const Bounds& box) {
  const glm::dvec3 extent = box.extent();
  const double side = std::max({extent.x, extent.y, extent.z, 1e-30});
  const glm::uvec3 cell(glm::clamp((point - box.min) / side, 0.0, 1.0) * 1023.0);
  return spread_out(cell.x) | spread_out(cell.y) << 1 | spread_out(cell.z) << 2;
}

glm::dvec3 corner(const Mesh& mesh, size_t index) { return mesh.vertices[mesh.indices[index]].position; }

std::vector<uint32_t> triangles_along_curve(const Mesh& mesh) {
  const Bounds box = bounds_of(mesh);
  std::vector<uint32_t> place(mesh.indices.size() / 3), order(place.size());
  for (size_t t = 0; t < place.size(); ++t)
    place[t] = place_along_curve((corner(mesh, 3 * t) + corner(mesh, 3 * t + 1) + corner(mesh, 3 * t + 2)) / 3.0, box);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return place[a] < place[b]; });
  return order;
}

}  // namespace

MeshInParts in_parts(const Mesh& mesh) {
  const size_t triangles = mesh.indices.size() / 3;
  const auto all = static_cast<uint32_t>(3 * triangles);
  if (triangles < kFewTriangles) return {mesh.indices, {{0, all, bounds_of(mesh)}}};
  MeshInParts out;
  out.indices.reserve(all);
  for (const uint32_t t : triangles_along_curve(mesh))
    for (uint32_t k = 0; k < 3; ++k) out.indices.push_back(mesh.indices[3 * t + k]);
  constexpr uint32_t kStep = 3 * kPartTriangles;
  for (uint32_t first = 0; first < all; first += kStep) {
    MeshPart part{first, std::min(kStep, all - first), kNoBounds};
    for (uint32_t i = 0; i < part.count; ++i)
      include(part.box, glm::dvec3(mesh.vertices[out.indices[first + i]].position));
    out.parts.push_back(part);
  }
  return out;
}

}  // namespace gbl
