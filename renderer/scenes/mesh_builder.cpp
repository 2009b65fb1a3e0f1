#include "renderer/scenes/mesh_builder.h"

#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"

namespace gbl {
namespace {

// Below this an edge of a bend is drawn sharp: cos 40 degrees.
constexpr double kSmoothCosine = 0.766;

void add_triangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

// Any unit vector orthogonal to the unit vector n.
glm::dvec3 some_orthogonal(glm::dvec3 n) {
  return glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

glm::dvec2 outward(glm::dvec2 from, glm::dvec2 to) { return glm::normalize(glm::dvec2(to.y - from.y, from.x - to.x)); }

// Normal of the profile at one end of a segment: shared with the neighbour unless the bend is an edge.
glm::dvec2 blended(glm::dvec2 own, glm::dvec2 neighbour) {
  return glm::dot(own, neighbour) > kSmoothCosine ? glm::normalize(own + neighbour) : own;
}

// The neighbour across the axis is the segment's own mirror image, so a round pole gets the axis as its normal and
// the tip of a cone stays sharp.
glm::dvec2 end_normal(std::span<const glm::dvec2> profile, size_t segment, bool top) {
  const glm::dvec2 own = outward(profile[segment], profile[segment + 1]);
  const size_t point = segment + (top ? 1 : 0);
  if (profile[point].x == 0) return blended(own, {-own.x, own.y});
  if (point == 0 || point + 1 == profile.size()) return own;
  return blended(own, top ? outward(profile[point], profile[point + 1]) : outward(profile[point - 1], profile[point]));
}

void add_ring(Mesh& mesh, glm::dvec2 point, glm::dvec2 normal, double v, int sides) {
  for (int j = 0; j <= sides; ++j) {
    const double angle = glm::two_pi<double>() * (j % sides) / sides;  // the seam closes to the bit
    const double c = std::cos(angle), s = std::sin(angle);
    mesh.vertices.push_back({.position = glm::dvec3(point.x * c, point.y, -point.x * s),
                             .normal = glm::dvec3(normal.x * c, normal.y, -normal.x * s),
                             .tangent = {},
                             .uv = glm::dvec2(static_cast<double>(j) / sides, v)});
  }
}

// Every triangle gets corners of its own and its own normal.
Mesh faceted(const Mesh& smooth) {
  Mesh flat;
  for (size_t i = 0; i < smooth.indices.size(); i += 3) {
    const std::array<Vertex, 3> corner = {smooth.vertices[smooth.indices[i]], smooth.vertices[smooth.indices[i + 1]],
                                          smooth.vertices[smooth.indices[i + 2]]};
    const glm::dvec3 a(corner[0].position), b(corner[1].position), c(corner[2].position);
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (Vertex v : corner) {
      v.normal = normal;
      flat.indices.push_back(static_cast<uint32_t>(flat.vertices.size()));
      flat.vertices.push_back(v);
    }
  }
  return flat;
}

}  // namespace

Mesh make_hexahedron(const std::array<glm::dvec3, 8>& corners, double uv_per_unit, glm::dvec2 uv_start) {
  // Lower left, lower right, upper right, upper left as seen from outside: +X, -X, +Y, -Y, +Z, -Z.
  constexpr int kFaces[6][4] = {{5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}, {4, 5, 7, 6}, {1, 0, 2, 3}};
  Mesh mesh;
  for (const auto& face : kFaces) {
    const glm::dvec3 origin = corners[face[0]];
    const glm::dvec3 normal =
        glm::normalize(glm::cross(corners[face[2]] - origin, corners[face[3]] - corners[face[1]]));
    const glm::dvec3 along = corners[face[1]] - origin;
    const glm::dvec3 right = glm::normalize(along - normal * glm::dot(normal, along));
    const glm::dvec3 up = glm::cross(normal, right);
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (int corner : face) {
      const glm::dvec3 p = corners[corner] - origin;
      const glm::dvec2 uv = uv_start + glm::dvec2(glm::dot(p, right), -glm::dot(p, up)) * uv_per_unit;
      mesh.vertices.push_back(
          {.position = corners[corner], .normal = normal, .tangent = glm::dvec4(right, 1), .uv = uv});
    }
    add_triangle(mesh, first, first + 1, first + 2);
    add_triangle(mesh, first, first + 2, first + 3);
  }
  return mesh;
}

Mesh make_box(glm::dvec3 low, glm::dvec3 high, double uv_per_unit, glm::dvec2 uv_start) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) corners[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  return make_hexahedron(corners, uv_per_unit, uv_start);
}

Mesh make_lathe(std::span<const glm::dvec2> profile, int sides) {
  assert(profile.size() >= 2 && sides >= 3);
  double length = 0, done = 0;
  for (size_t k = 0; k + 1 < profile.size(); ++k) length += glm::distance(profile[k], profile[k + 1]);
  Mesh mesh;
  for (size_t k = 0; k + 1 < profile.size(); ++k) {
    const auto below = static_cast<uint32_t>(mesh.vertices.size());
    const uint32_t above = below + static_cast<uint32_t>(sides) + 1;
    add_ring(mesh, profile[k], end_normal(profile, k, false), 1 - done / length, sides);
    done += glm::distance(profile[k], profile[k + 1]);
    add_ring(mesh, profile[k + 1], end_normal(profile, k, true), 1 - done / length, sides);
    for (uint32_t j = 0; j < static_cast<uint32_t>(sides); ++j) {  // at a pole one of the two has no area
      if (profile[k].x > 0) add_triangle(mesh, below + j, below + j + 1, above + j + 1);
      if (profile[k + 1].x > 0) add_triangle(mesh, below + j, above + j + 1, above + j);
    }
  }
  set_tangents(mesh);
  return mesh;
}

Mesh make_ellipsoid(glm::dvec3 radii, int sides, int rings) {
  std::vector<glm::dvec2> profile = {{0, -1}};
  for (int i = 1; i < rings; ++i) {
    const double angle = glm::pi<double>() * i / rings;
    profile.emplace_back(std::sin(angle), -std::cos(angle));
  }
  profile.emplace_back(0, 1);
  Mesh mesh;
  append(mesh, make_lathe(profile, sides), glm::scale(glm::dmat4(1), radii));
  return mesh;
}

Mesh make_boulder(glm::dvec3 radii, double roughness, uint64_t seed, double uv_per_unit) {
  constexpr int kSides = 9, kRings = 6;
  Mesh ball = make_ellipsoid(glm::dvec3(1), kSides, kRings);
  // One factor per latitude and longitude: corners that share a place must move together.
  Pcg32 rng(seed);
  double factor[kRings + 1][kSides];
  for (auto& ring : factor)
    for (double& f : ring) f = 1 + roughness * rng.in(-1, 1);
  for (Vertex& v : ball.vertices) {
    const double y = glm::clamp(static_cast<double>(v.position.y), -1.0, 1.0);
    const auto ring = static_cast<int>(std::lround(std::acos(-y) / glm::pi<double>() * kRings));
    const auto side = static_cast<int>(std::lround(v.uv.x * kSides)) % kSides;
    const bool pole = ring == 0 || ring == kRings;
    v.position = glm::dvec3(v.position) * radii * factor[ring][pole ? 0 : side];
    v.uv = glm::dvec2(v.uv) * glm::dvec2(6, 3) * (radii.x + radii.z) / 2.0 * uv_per_unit;
  }
  Mesh boulder = faceted(ball);
  set_tangents(boulder);
  return boulder;
}

void append(Mesh& to, const Mesh& part, const glm::dmat4& to_from_part, const UvPart& uv) {
  const glm::dmat3 linear(to_from_part);
  assert(glm::determinant(linear) > 0 && uv.scale.x > 0 && uv.scale.y > 0);
  const glm::dmat3 for_normals = glm::transpose(glm::inverse(linear));
  const auto first = static_cast<uint32_t>(to.vertices.size());
  for (const Vertex& v : part.vertices) {
    const glm::dvec3 normal = glm::normalize(for_normals * glm::dvec3(v.normal));
    const glm::dvec3 along = linear * glm::dvec3(v.tangent);
    const glm::dvec3 tangent = glm::normalize(along - normal * glm::dot(normal, along));
    to.vertices.push_back({.position = glm::dvec3(to_from_part * glm::dvec4(glm::dvec3(v.position), 1)),
                           .normal = normal,
                           .tangent = glm::dvec4(tangent, v.tangent.w),
                           .uv = glm::dvec2(v.uv) * uv.scale + uv.offset});
  }
  for (uint32_t index : part.indices) to.indices.push_back(first + index);
}

void set_tangents(Mesh& mesh) {
  std::vector<glm::dvec3> along_u(mesh.vertices.size(), glm::dvec3(0));
  std::vector<double> turn(mesh.vertices.size(), 0);
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::dvec3 ab(b.position - a.position), ac(c.position - a.position);
    const glm::dvec2 uv_ab(b.uv - a.uv), uv_ac(c.uv - a.uv);
    const double area = uv_ab.x * uv_ac.y - uv_ac.x * uv_ab.y;  // negative where u right, v down is not mirrored
    const glm::dvec3 u = (ab * uv_ac.y - ac * uv_ab.y) * (area < 0 ? -1.0 : 1.0);
    for (size_t k = i; k < i + 3; ++k) {
      along_u[mesh.indices[k]] += u;
      turn[mesh.indices[k]] -= area;
    }
  }
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::dvec3 normal(mesh.vertices[i].normal);
    const glm::dvec3 in_plane = along_u[i] - normal * glm::dot(normal, along_u[i]);
    const double length = glm::length(in_plane);
    const glm::dvec3 tangent = length > 0 ? in_plane / length : some_orthogonal(normal);
    mesh.vertices[i].tangent = glm::dvec4(tangent, turn[i] < 0 ? -1 : 1);
  }
}

glm::dmat4 pointing(glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 y = glm::normalize(to - from);
  const glm::dvec3 z = some_orthogonal(y);
  return {glm::dvec4(glm::cross(y, z), 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(from, 1)};
}

}  // namespace gbl
