#include "renderer/gltf/tangents.h"

#include <cmath>
#include <string_view>
#include <unordered_map>

namespace gbl {
namespace {

struct Corner {  // what makes corners equal
  glm::vec3 position, normal;
  glm::vec2 uv;
  bool operator==(const Corner&) const = default;
};
static_assert(sizeof(Corner) == 8 * sizeof(float), "no padding: hashed as bytes");

struct CornerHash {
  size_t operator()(const Corner& corner) const {
    return std::hash<std::string_view>()({reinterpret_cast<const char*>(&corner), sizeof corner});
  }
};

struct Face {
  glm::dvec3 along_u{0};
  int orientation = 0;  // +1, -1: the picture on the surface is mirrored; 0: no area in uv
};

constexpr uint32_t kNone = 0xffffffff;

// uv with v upwards: a normal map's green points to the top of the picture, glTF's v to its bottom.
glm::dvec2 upward_uv(const Vertex& vertex, int uv_set, const glm::mat3& transform) {
  const glm::vec3 uv = transform * glm::vec3(uv_set == 1 ? vertex.uv1 : vertex.uv, 1);
  return {uv.x, -uv.y};
}

Face face_of(const Vertex* const v[3], int uv_set, const glm::mat3& transform) {
  const glm::dvec2 uv = upward_uv(*v[0], uv_set, transform);
  const glm::dvec2 a = upward_uv(*v[1], uv_set, transform) - uv, b = upward_uv(*v[2], uv_set, transform) - uv;
  const double area = a.x * b.y - a.y * b.x;
  const glm::dvec3 p(v[0]->position);
  const glm::dvec3 along = b.y * (glm::dvec3(v[1]->position) - p) - a.y * (glm::dvec3(v[2]->position) - p);
  const double length = glm::length(along);
  if (area == 0 || !(length > 0) || !std::isfinite(length) || !std::isfinite(area)) return {};
  return {along * (std::copysign(1.0, area) / length), area > 0 ? 1 : -1};
}

glm::dvec3 laid_into_plane(const glm::dvec3& v, const glm::dvec3& normal) {
  const glm::dvec3 flat = v - normal * glm::dot(normal, v);
  const double length = glm::length(flat);
  return length > 0 ? flat / length : glm::dvec3(0);
}

// Between the edges that leave a corner, seen along the corner's normal.
double corner_angle(const Vertex& at, const Vertex& next, const Vertex& last) {
  const glm::dvec3 n(at.normal), p(at.position);
  const glm::dvec3 a = laid_into_plane(glm::dvec3(next.position) - p, n);
  const glm::dvec3 b = laid_into_plane(glm::dvec3(last.position) - p, n);
  return std::acos(glm::clamp(glm::dot(a, b), -1.0, 1.0));
}

class Groups {
 public:
  Groups(const Mesh& mesh, int uv_set) {
    std::unordered_map<Corner, uint32_t, CornerHash> known;
    known.reserve(mesh.vertices.size());
    for (const Vertex& v : mesh.vertices) {
      // Adding 0 makes -0 and 0 the same bits.
      const Corner corner{v.position + 0.f, v.normal + 0.f, (uv_set == 1 ? v.uv1 : v.uv) + 0.f};
      of_vertex_.push_back(known.emplace(corner, static_cast<uint32_t>(known.size())).first->second);
    }
    sums_.resize(2 * known.size(), glm::dvec3(0));
  }
  glm::dvec3& sum(uint32_t vertex, int orientation) { return sums_[2 * of_vertex_[vertex] + (orientation < 0)]; }

 private:
  std::vector<uint32_t> of_vertex_;
  std::vector<glm::dvec3> sums_;
};

bool usable(const glm::dvec3& sum) { return glm::dot(sum, sum) > 1e-30; }

glm::vec4 tangent_of(const glm::dvec3& sum, int orientation, const glm::vec3& normal) {
  if (!usable(sum)) return {glm::vec3(any_tangent(normal)), static_cast<float>(orientation)};
  return {glm::vec3(glm::normalize(sum)), static_cast<float>(orientation)};
}

}  // namespace

glm::vec4 any_tangent(const glm::vec3& normal) {
  // The axis that the normal leans to least.
  const glm::vec3 a = glm::abs(normal);
  const glm::vec3 axis = a.x <= a.y && a.x <= a.z ? glm::vec3(1, 0, 0)
                         : a.y <= a.z             ? glm::vec3(0, 1, 0)
                                                  : glm::vec3(0, 0, 1);
  return {glm::normalize(axis - normal * glm::dot(axis, normal)), 1};
}

void make_tangents(Mesh& mesh, int uv_set, const glm::mat3& uv_transform) {
  Groups groups(mesh, uv_set);
  std::vector<int> orientation(mesh.indices.size() / 3);
  for (size_t f = 0; f < orientation.size(); ++f) {
    const uint32_t* corner = &mesh.indices[3 * f];
    const Vertex* v[3] = {&mesh.vertices[corner[0]], &mesh.vertices[corner[1]], &mesh.vertices[corner[2]]};
    const Face face = face_of(v, uv_set, uv_transform);
    orientation[f] = face.orientation;
    if (face.orientation == 0) continue;
    for (int c = 0; c < 3; ++c)
      groups.sum(corner[c], face.orientation) += laid_into_plane(face.along_u, glm::dvec3(v[c]->normal)) *
                                                 corner_angle(*v[c], *v[(c + 1) % 3], *v[(c + 2) % 3]);
  }
  // A vertex keeps the orientation that comes first; the other gets a copy of it.
  const size_t count = mesh.vertices.size();
  std::vector<int> kept(count, 0);
  std::vector<uint32_t> copy(count, kNone);
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const uint32_t vertex = mesh.indices[i];
    int wanted = orientation[i / 3];
    if (wanted == 0)
      wanted = kept[vertex] ? kept[vertex] : !usable(groups.sum(vertex, 1)) && usable(groups.sum(vertex, -1)) ? -1 : 1;
    if (kept[vertex] == 0) {
      kept[vertex] = wanted;
      mesh.vertices[vertex].tangent = tangent_of(groups.sum(vertex, wanted), wanted, mesh.vertices[vertex].normal);
    }
    if (kept[vertex] == wanted) continue;
    if (copy[vertex] == kNone) {
      copy[vertex] = static_cast<uint32_t>(mesh.vertices.size());
      Vertex other = mesh.vertices[vertex];
      other.tangent = tangent_of(groups.sum(vertex, wanted), wanted, other.normal);
      mesh.vertices.push_back(other);
    }
    mesh.indices[i] = copy[vertex];
  }
  for (size_t v = 0; v < count; ++v)
    if (kept[v] == 0) mesh.vertices[v].tangent = any_tangent(mesh.vertices[v].normal);  // no triangle uses it
}

}  // namespace gbl
