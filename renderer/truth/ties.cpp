#include "renderer/truth/ties.h"

#include <algorithm>

#include "renderer/truth/visible_triangles.h"

namespace gbl {
namespace {

// Corners are moved to the grid's nearest point, half a step at most along x and y; two surfaces, one against the other, by
// twice that. So the points around the centre are a whole step away along x, y or both. The centre is one of them: the
// double there may see another surface than the driver said.
constexpr double kSteps[] = {-kRasterPx, 0, kRasterPx};

}  // namespace

std::vector<Rival> rivals_of(const Settings& s, const Scene& scene, std::span<const SeenSurface> seen,
                             const std::atomic<bool>* cancel) {
  std::vector<Rival> rivals;
  for (const double x : kSteps)
    for (const double y : kSteps) {
      if (cancel && *cancel) return {};
      for (const Rival& there : seen_aside(s, scene, {x, y}, kSameRange))
        if (there.surface != seen[there.pixel]) rivals.push_back(there);
    }
  std::sort(rivals.begin(), rivals.end());
  rivals.erase(std::unique(rivals.begin(), rivals.end()), rivals.end());
  rivals.shrink_to_fit();
  return rivals;
}

bool is_tie(const Truth& truth, size_t pixel, SeenSurface frames) {
  return std::binary_search(truth.rivals.begin(), truth.rivals.end(), Rival{pixel, frames});
}

}  // namespace gbl
