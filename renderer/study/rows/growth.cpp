#include "renderer/study/rows/growth.h"

#include <cmath>

namespace gbl {

std::vector<double> growth_powers(std::span<const GrowthPoint> points) {
  std::vector<double> out;
  for (size_t i = 1; i < points.size(); ++i)
    out.push_back(std::log(points[i].cost / points[i - 1].cost) / std::log(points[i].x / points[i - 1].x));
  return out;
}

std::optional<double> growth_bend(std::span<const GrowthPoint> points) {
  const std::vector<double> powers = growth_powers(points);
  size_t first = powers.size();
  while (first > 0 && powers[first - 1] > 0.5) --first;
  return first == powers.size() ? std::nullopt : std::optional(points[first].x);
}

}  // namespace gbl
