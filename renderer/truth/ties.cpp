#include "renderer/truth/ties.h"

#include <algorithm>

#include "renderer/truth/visible_triangles.h"

namespace gbl {
namespace {

// Corners are moved to the grid's nearest point, half a step at most along x and y; two surfaces, one against the other, by
// twice that. So the points around the centre are a whole step away along x, y or both. The centre is one of them: the
// double there may see another surface than the driver said.
constexpr double kSteps[] = {-kRasterPx, 0, kRasterPx};
static_assert(kRivalPlaces == std::size(kSteps) * std::size(kSteps));

}  // namespace

void add_rivals(int place, const Settings& s, const Scene& scene, std::span<const SeenSurface> seen,
                std::vector<Rival>& rivals) {
  const glm::dvec2 aside_px(kSteps[place / 3], kSteps[place % 3]);
  for (const Rival& there : seen_aside(s, scene, aside_px, kSameRange))
    if (there.surface != seen[there.pixel]) rivals.push_back(there);
}

void put_in_order(std::vector<Rival>& rivals) {
  std::sort(rivals.begin(), rivals.end());
  rivals.erase(std::unique(rivals.begin(), rivals.end()), rivals.end());
  rivals.shrink_to_fit();
}

std::vector<Rival> rivals_of(const Settings& s, const Scene& scene, std::span<const SeenSurface> seen) {
  std::vector<Rival> rivals;
  for (int place = 0; place < kRivalPlaces; ++place) add_rivals(place, s, scene, seen, rivals);
  put_in_order(rivals);
  return rivals;
}

bool is_tie(const Truth& truth, size_t pixel, SeenSurface frames) {
  return std::binary_search(truth.rivals.begin(), truth.rivals.end(), Rival{pixel, frames});
}

}  // namespace gbl
