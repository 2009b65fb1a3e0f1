#pragma once
// What every mesh of the lab promises, as one check for all tests that make meshes.
#include <cmath>
#include <string>

#include "renderer/scene/scene.h"

namespace gbl {

// The first broken promise, or nothing.
inline std::string broken_promise(const Mesh& mesh) {
  if (mesh.indices.empty() || mesh.indices.size() % 3) return "not a list of triangles";
  for (uint32_t index : mesh.indices)
    if (index >= mesh.vertices.size()) return "index out of range";
  for (const Vertex& v : mesh.vertices) {
    const glm::dvec3 n(v.normal), t(v.tangent);
    if (!(std::abs(glm::length(n) - 1) < 1e-5)) return "normal not unit";
    if (!(std::abs(glm::length(t) - 1) < 1e-5)) return "tangent not unit";
    if (!(std::abs(glm::dot(n, t)) < 1e-5)) return "tangent not orthogonal";
    if (v.tangent.w != 1 && v.tangent.w != -1) return "w is not +1 or -1";
  }
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const glm::dvec3 ab(mesh.vertices[mesh.indices[i + 1]].position - a.position);
    const glm::dvec3 ac(mesh.vertices[mesh.indices[i + 2]].position - a.position);
    const glm::dvec2 uv_ab(mesh.vertices[mesh.indices[i + 1]].uv - a.uv);
    const glm::dvec2 uv_ac(mesh.vertices[mesh.indices[i + 2]].uv - a.uv);
    const glm::dvec3 face = glm::cross(ab, ac);
    const double area = uv_ab.x * uv_ac.y - uv_ac.x * uv_ab.y;
    if (glm::length(face) < 1e-6 || std::abs(area) < 1e-12) return "triangle without area";
    const glm::dvec3 along_u = (ab * uv_ac.y - ac * uv_ab.y) / area, along_v = (ac * uv_ab.x - ab * uv_ac.x) / area;
    for (size_t k = i; k < i + 3; ++k) {
      const Vertex& v = mesh.vertices[mesh.indices[k]];
      const glm::dvec3 n(v.normal), t(v.tangent);
      if (glm::dot(face, n) <= 0) return "triangle not counter-clockwise seen from outside";
      if (glm::dot(along_u, t) <= 0) return "tangent does not follow u";
      if (glm::dot(along_v, glm::cross(n, t) * static_cast<double>(v.tangent.w)) >= 0) return "bitangent follows v";
    }
  }
  return "";
}

}  // namespace gbl
