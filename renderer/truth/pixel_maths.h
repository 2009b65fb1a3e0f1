#pragma once
// Of one pixel's three channels.
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace gbl {

inline bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline int largest_channel(const glm::dvec3& v) {
  const int k = v.y > v.x ? 1 : 0;
  return v.z > v[k] ? 2 : k;
}

// Of a difference: infinite when it is not a number.
inline double largest_magnitude(const glm::dvec3& d) {
  const glm::dvec3 a = glm::abs(d);
  return finite(d) ? a[largest_channel(a)] : std::numeric_limits<double>::infinity();
}

}  // namespace gbl
