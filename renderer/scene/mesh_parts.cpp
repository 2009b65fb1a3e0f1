#include "renderer/scene/mesh_parts.h"

#include <algorithm>
#include <meshoptimizer.h>
#include <span>

namespace gbl {
namespace {

constexpr uint32_t kNone = ~0u;
constexpr size_t kFewTriangles = 4 * kPartTriangles;

std::vector<uint32_t> triangles_that_lie_together(const Mesh& mesh) {
  std::vector<uint32_t> out(mesh.indices.size());
  meshopt_spatialSortTriangles(out.data(), mesh.indices.data(), mesh.indices.size(), &mesh.vertices[0].position.x,
                               mesh.vertices.size(), sizeof(Vertex));
  return out;
}

// Numbers the vertices of a few triangles from 0: the library's time goes with the greatest number, not with how many there are.
class FewVertices {
 public:
  explicit FewVertices(size_t all) : number_(all, kNone) {}
  void number(std::span<uint32_t> indices) {
    for (const uint32_t v : used_) number_[v] = kNone;
    used_.clear();
    for (uint32_t& i : indices) {
      if (number_[i] == kNone) number_[i] = static_cast<uint32_t>(used_.size()), used_.push_back(i);
      i = number_[i];
    }
  }
  const std::vector<uint32_t>& used() const { return used_; }

 private:
  std::vector<uint32_t> number_, used_;
};

// A corner that was worked out a moment ago is not worked out again (Forsyth 2006, "Linear-Speed Vertex Cache Optimisation").
void order_triangles(FewVertices& few, std::span<uint32_t> indices) {
  few.number(indices);
  meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(), few.used().size());
  for (uint32_t& i : indices) i = few.used()[i];
}

Bounds box_of(const Mesh& mesh, std::span<const uint32_t> indices) {
  Bounds box = kNoBounds;
  for (const uint32_t i : indices) include(box, glm::dvec3(mesh.vertices[i].position));
  return box;
}

}  // namespace

MeshInParts in_parts(const Mesh& mesh) {
  const size_t all = mesh.indices.size();
  const bool few_triangles = all < 3 * kFewTriangles;
  MeshInParts out{{}, few_triangles ? mesh.indices : triangles_that_lie_together(mesh), {}};
  const size_t step = few_triangles ? all : 3 * kPartTriangles;
  FewVertices few(mesh.vertices.size());
  for (size_t first = 0; first < all; first += step) {
    const std::span part = std::span(out.indices).subspan(first, std::min(step, all - first));
    order_triangles(few, part);
    out.parts.push_back({static_cast<uint32_t>(first), static_cast<uint32_t>(part.size()), box_of(mesh, part)});
  }
  few.number(out.indices);
  out.vertices = few.used();
  return out;
}

}  // namespace gbl
