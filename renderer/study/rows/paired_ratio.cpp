#include "renderer/study/rows/paired_ratio.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace gbl {

PairedRatio paired_ratio(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size() && !a.empty());
  std::vector<double> ratios;
  for (size_t i = 0; i < a.size(); ++i) ratios.push_back(b[i] / a[i]);
  std::sort(ratios.begin(), ratios.end());
  const size_t n = ratios.size();
  constexpr double kNormal95 = 1.96;
  const double rank = (static_cast<double>(n) - kNormal95 * std::sqrt(static_cast<double>(n))) / 2;  // from 1
  const size_t left_out = n < kLeastRounds || rank < 1 ? 0 : static_cast<size_t>(rank) - 1;
  return {(ratios[(n - 1) / 2] + ratios[n / 2]) / 2, ratios[left_out], ratios[n - 1 - left_out]};
}

}  // namespace gbl
