#pragma once
// One primitive of a mesh as the renderer's Mesh: triangles, normals, tangents, all finite.
#include <string>
#include <vector>

#include "renderer/gltf/gltf_accessor.h"
#include "renderer/scene/scene.h"

namespace gbl::gltf {

// World from bind pose, per joint of a skin. Empty: the mesh is not skinned.
using JointMatrices = std::vector<glm::dmat4>;

// What the material's normal map needs of the vertices.
struct TangentNeed {
  bool needed = false;
  int uv_set = 0;
  glm::mat3 uv_transform{1};
};

// Broken: the primitive cannot be drawn. An empty mesh: none of its triangles has an area (noted).
Mesh build_mesh(const Document&, const Primitive&, const JointMatrices&, const TangentNeed&, const std::string& name,
                Job&);

// Vertex attributes as they stand in the file, unit and finite where they must be. (gltf_vertices.cpp)
struct VertexData {
  std::vector<Vertex> vertices;
  bool has_normals = false, has_tangents = false;
  std::vector<bool> unusable;  // position not finite or out of all bounds
};
VertexData read_vertices(const Document&, const Primitive&, const JointMatrices&, const std::string& name, Job&);

// Triangles of any mode, each index in range. (gltf_triangles.cpp; specification 3.7.2.1)
std::vector<uint32_t> read_triangles(const Document&, const Primitive&, size_t vertex_count);

}  // namespace gbl::gltf
