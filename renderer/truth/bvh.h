#pragma once
// A tree of boxes, so that a ray looks at few of many things: binned by the surface-area heuristic (Wald 2007, "On fast
// Construction of SAH-based Bounding Volume Hierarchies"). In double; it never leaves out what the ray meets.
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

// A ray, and the part of it that counts: origin + t * direction, from < t < to. The direction need not be of length 1.
struct RayPart {
  glm::dvec3 origin{0}, direction{0, 0, -1};
  double from = 0, to = 0;
};

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const Bounds> boxes);
  Bounds bounds() const { return nodes_.empty() ? Bounds{} : nodes_[0].box; }

  // visit(item, part) for each box that the part may meet, near ones first. It may shorten `part.to`; true: no more.
  // True if one said so.
  template <class Visit>
  bool along(RayPart part, Visit visit) const {
    if (nodes_.empty()) return false;
    const glm::dvec3 inverse = 1.0 / part.direction;
    uint32_t stack[kMostDepth];
    size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& n = nodes_[stack[--depth]];
      if (!meets(n.box, part, inverse)) continue;
      if (n.count == 0) {
        const bool left_first = part.direction[n.axis] >= 0;
        stack[depth++] = left_first ? n.second : n.first;
        stack[depth++] = left_first ? n.first : n.second;
        continue;
      }
      for (uint32_t i = n.first; i < n.first + n.count; ++i)
        if (visit(items_[i], part)) return true;
    }
    return false;
  }

 private:
  static constexpr size_t kMostDepth = 128;
  struct Node {
    Bounds box;
    uint32_t first = 0, second = 0;  // children; of a leaf the first item
    uint32_t count = 0;              // items; 0: not a leaf
    int axis = 0;                    // along which the children were told apart
  };
  struct Build;

  // A NaN (0 times infinity, a ray along a side's plane) is no reason to miss: the comparisons keep the other number.
  static bool meets(const Bounds& box, const RayPart& part, const glm::dvec3& inverse) {
    double from = part.from, to = part.to;
    for (int k = 0; k < 3; ++k) {
      const double a = (box.min[k] - part.origin[k]) * inverse[k], b = (box.max[k] - part.origin[k]) * inverse[k];
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    return from <= to;
  }
  uint32_t add(Build&, uint32_t begin, uint32_t end, size_t depth);

  std::vector<Node> nodes_;
  std::vector<uint32_t> items_;
};

}  // namespace gbl
