#include "renderer/picture/picture_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gbl {

double largest_square_difference(const Image& a, const Image& b, int side) {
  assert(a.size == b.size && side > 0);
  double most = 0;
  for (int top = 0; top < a.size.y; top += side)
    for (int left = 0; left < a.size.x; left += side) {
      const glm::ivec2 end = glm::min(glm::ivec2(left, top) + side, a.size);
      glm::dvec3 sum(0);
      for (int y = top; y < end.y; ++y)
        for (int x = left; x < end.x; ++x) {
          const size_t i = 4 * (static_cast<size_t>(y) * static_cast<size_t>(a.size.x) + static_cast<size_t>(x));
          for (int k = 0; k < 3; ++k)
            sum[k] += double(a.rgba[i + static_cast<size_t>(k)]) - b.rgba[i + static_cast<size_t>(k)];
        }
      for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(sum[k]) / ((end.x - left) * (end.y - top)));
    }
  return most;
}

}  // namespace gbl
