#include "renderer/gltf/gltf_primitive.h"

#include <cmath>
#include <fmt/format.h>

#include "renderer/gltf/gltf_limits.h"
#include "renderer/gltf/tangents.h"

namespace gbl::gltf {
namespace {

glm::dvec3 face_normal(const std::vector<Vertex>& v, const uint32_t* corner) {
  const glm::dvec3 p(v[corner[0]].position);
  return glm::cross(glm::dvec3(v[corner[1]].position) - p, glm::dvec3(v[corner[2]].position) - p);
}

bool is_zero(const glm::vec3& v) { return v == glm::vec3(0); }

// Triangles that would spread NaN are dropped: those with a corner at no usable place, and in a mesh whose normals are
// made from its triangles those without area. Elsewhere the latter are harmless: no pixel shows them.
void drop_bad_triangles(std::vector<uint32_t>& indices, const VertexData& data, const std::string& name, Job& job) {
  size_t kept = 0, infinite = 0, with_area = 0;
  for (size_t i = 0; i < indices.size(); i += 3) {
    const uint32_t corner[3] = {indices[i], indices[i + 1], indices[i + 2]};
    const bool unusable = data.unusable[corner[0]] || data.unusable[corner[1]] || data.unusable[corner[2]];
    const bool has_area = !unusable && face_normal(data.vertices, corner) != glm::dvec3(0);
    infinite += unusable;
    with_area += has_area;
    if (unusable || !(has_area || data.has_normals)) continue;
    for (const uint32_t c : corner) indices[kept++] = c;
  }
  indices.resize(with_area > 0 ? kept : 0);
  if (infinite > 0)
    job.note(
        fmt::format("mesh '{}': {} triangles with positions that are no usable numbers; left out", name, infinite));
  if (with_area == 0) job.note(fmt::format("mesh '{}': no triangle has an area; not drawn", name));
}

// Vertices at the corners of a dropped triangle only are dropped with it: they must not count in bounds.
void drop_unused_vertices(Mesh& mesh) {
  std::vector<uint32_t> moved(mesh.vertices.size(), 0);
  for (const uint32_t index : mesh.indices) moved[index] = 1;
  uint32_t kept = 0;
  for (size_t i = 0; i < moved.size(); ++i) {
    if (!moved[i]) continue;
    mesh.vertices[kept] = mesh.vertices[i];
    moved[i] = kept++;
  }
  if (kept == mesh.vertices.size()) return;
  mesh.vertices.resize(kept);
  for (uint32_t& index : mesh.indices) index = moved[index];
}

// Specification 3.7.2.1: without normals a mesh is flat, so each triangle has vertices of its own.
void make_flat(Mesh& mesh) {
  if (mesh.indices.size() > kMaxVertices) throw Broken(fmt::format("{} flat corners, too many", mesh.indices.size()));
  std::vector<Vertex> own;
  own.reserve(mesh.indices.size());
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    // Normalised twice: the cross product of a tiny triangle underflows when squared.
    const glm::dvec3 cross = face_normal(mesh.vertices, &mesh.indices[i]);
    const double largest = std::max({std::abs(cross.x), std::abs(cross.y), std::abs(cross.z)});
    const glm::vec3 normal(glm::normalize(cross / largest));
    for (size_t c = 0; c < 3; ++c) {
      own.push_back(mesh.vertices[mesh.indices[i + c]]);
      own.back().normal = normal;
    }
  }
  mesh.vertices = std::move(own);
  for (size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = static_cast<uint32_t>(i);
}

// Normals of zero length: the mean of the triangles around, by area.
void fix_normals(Mesh& mesh, Job& job) {
  std::vector<uint32_t> zero;
  for (size_t i = 0; i < mesh.vertices.size(); ++i)
    if (is_zero(mesh.vertices[i].normal)) zero.push_back(static_cast<uint32_t>(i));
  if (zero.empty()) return;
  job.note(fmt::format("mesh '{}': {} normals without a direction; made from the triangles", mesh.name, zero.size()));
  std::vector<glm::dvec3> sum(mesh.vertices.size(), glm::dvec3(0));
  for (size_t i = 0; i < mesh.indices.size(); i += 3)
    for (size_t c = 0; c < 3; ++c) sum[mesh.indices[i + c]] += face_normal(mesh.vertices, &mesh.indices[i]);
  for (const uint32_t v : zero) {
    const double length = glm::length(sum[v]);
    mesh.vertices[v].normal = length > 0 && std::isfinite(length) ? glm::vec3(sum[v] / length) : glm::vec3(0, 1, 0);
  }
}

void fix_tangents(Mesh& mesh, bool given) {
  for (Vertex& v : mesh.vertices)
    if (!given || is_zero(glm::vec3(v.tangent)) || !std::isfinite(v.tangent.x)) v.tangent = any_tangent(v.normal);
}

}  // namespace

Mesh build_mesh(const Document& document, const Primitive& primitive, const JointMatrices& joints,
                const TangentNeed& need, const std::string& name, Job& job) {
  Mesh mesh;
  mesh.name = name;
  VertexData data = read_vertices(document, primitive, joints, name, job);
  mesh.indices = read_triangles(document, primitive, data.vertices.size());
  drop_bad_triangles(mesh.indices, data, name, job);
  mesh.vertices = std::move(data.vertices);
  if (mesh.indices.empty()) return {};
  drop_unused_vertices(mesh);
  if (data.has_normals)
    fix_normals(mesh, job);
  else
    make_flat(mesh);
  const bool has_uv = primitive.uv[need.uv_set] >= 0;
  if (need.needed && !data.has_tangents && has_uv)
    make_tangents(mesh, need.uv_set, need.uv_transform);
  else
    fix_tangents(mesh, data.has_tangents);
  if (need.needed && !data.has_tangents && !has_uv)
    job.note(fmt::format("mesh '{}': a normal map, but no texture coordinates for it", name));
  return mesh;
}

}  // namespace gbl::gltf
