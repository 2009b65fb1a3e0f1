#pragma once
// Filters of pictures with one number a pixel, row by row and then column by column.
#include <glm/glm.hpp>
#include <vector>

namespace gbl {

struct Plane {
  explicit Plane(glm::ivec2 s) : size(s), values(static_cast<size_t>(s.x) * static_cast<size_t>(s.y)) {}
  double* row(int y) { return values.data() + static_cast<size_t>(y) * static_cast<size_t>(size.x); }
  const double* row(int y) const { return values.data() + static_cast<size_t>(y) * static_cast<size_t>(size.x); }

  glm::ivec2 size;
  std::vector<double> values;
};

struct Kernel {
  int radius() const { return static_cast<int>(weights.size()) / 2; }

  std::vector<double> weights;  // an odd number; the middle one is the pixel's own
};

// Beyond the picture's edge its outermost pixels go on.
Plane filtered_along_x(const Plane&, const Kernel&);
Plane filtered_along_y(const Plane&, const Kernel&);

}  // namespace gbl
