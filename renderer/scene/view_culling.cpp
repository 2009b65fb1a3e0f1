#include "renderer/scene/view_culling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gbl {
namespace {

constexpr double kFloatSlack = 1e-4;  // of a coordinate

// How far a point is within each side of the view; below 0: beyond it.
std::array<double, 6> within(const glm::dvec4& p, DepthRuns runs) {
  const bool reversed = runs == DepthRuns::reversed;  // depth 1 … 0, else -1 … 1
  return {p.w - p.x, p.w + p.x, p.w - p.y, p.w + p.y, p.w - p.z, reversed ? p.z : p.w + p.z};
}

}  // namespace

bool may_be_seen(const Bounds& box, const glm::dmat4& clip_from_box, DepthRuns runs) {
  std::array<bool, 6> beyond;
  beyond.fill(true);
  for (const glm::dvec3& corner : corners_of(box)) {
    const glm::dvec4 p = clip_from_box * glm::dvec4(corner, 1);
    const double slack = kFloatSlack * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z) + std::abs(p.w));
    const std::array<double, 6> sides = within(p, runs);
    for (size_t k = 0; k < sides.size(); ++k) beyond[k] = beyond[k] && sides[k] < -slack;
  }
  return std::none_of(beyond.begin(), beyond.end(), [](bool b) { return b; });
}

}  // namespace gbl
