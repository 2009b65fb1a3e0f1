#include <cassert>

#include "renderer/truth/measure.h"
#include "renderer/truth/pixel_maths.h"

namespace gbl {

// Radiance first: a clamped infinity would look like white.
double display_difference(const Display& display, const glm::dvec3& radiance, const glm::dvec3& shown_truth) {
  if (!finite(radiance)) return std::numeric_limits<double>::infinity();
  return largest_magnitude(displayed(display, radiance) - shown_truth);
}

BoundCheck check_bound(const Truth& truth, std::span<const glm::vec3> lit, std::span<const glm::vec3> witness_lit,
                       const Display& display, double bound) {
  assert(lit.size() == truth.pixels() && (witness_lit.empty() || witness_lit.size() == truth.pixels()));
  BoundCheck check;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    ++check.compared;
    const glm::dvec3 shown_truth = displayed(display, truth.lit[i]);
    if (!witness_lit.empty() && display_difference(display, witness_lit[i], shown_truth) > bound) {
      ++check.excused;
      continue;
    }
    const double difference = display_difference(display, lit[i], shown_truth);
    if (difference > bound) ++check.over;
    if (check.worst_pixel.x >= 0 && !(difference > check.worst)) continue;
    check.worst = difference;
    check.worst_pixel = {static_cast<int>(i) % truth.size.x, static_cast<int>(i) / truth.size.x};
  }
  return check;
}

}  // namespace gbl
