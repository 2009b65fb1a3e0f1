#pragma once
// Where a ray meets a triangle's plane within the triangle: Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle
// Intersection". In double; borders belong to the triangle, so that no ray slips between two.
#include <glm/glm.hpp>
#include <optional>

namespace gbl {

struct TriangleHit {
  double distance = 0;       // in lengths of the direction; may be negative
  glm::dvec3 weights{0};     // of the corners
  bool from_behind = false;  // the corners go clockwise as seen along the ray
};

inline std::optional<TriangleHit> meet(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a,
                                       const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return {};
  const glm::dvec3 from_a = origin - a, q = glm::cross(from_a, ab);
  const double u = glm::dot(from_a, p) / determinant, v = glm::dot(direction, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return {};
  return TriangleHit{glm::dot(ac, q) / determinant, {1 - u - v, u, v}, determinant < 0};
}

}  // namespace gbl
