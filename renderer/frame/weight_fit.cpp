#include "renderer/frame/weight_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gbl {
namespace {

// How much a weight that is as llvmpipe's counts, beside one measurement that is met: little.
constexpr double kPrior = 1e-3;
constexpr int kSweeps = 2000;  // far more than the few dozen that such a system takes

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Least squares, none below 0, by going from weight to weight: each takes its best value while the others stay. It
// converges, since what is left is convex (Franc, Hlavac and Navara 2005, "Sequential Coordinate-Wise Algorithm for the
// Non-negative Least Squares Problem"). `weights` in ns, where to begin and what the prior holds them to.
void settle(std::span<const MeasuredWork> measured, WorkCounts& weights) {
  const WorkCounts begun = weights;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const WorkRow& r : kWork) {
      double slope = kPrior / begun[r.work], bent = kPrior / (begun[r.work] * begun[r.work]);
      for (const MeasuredWork& m : measured) {
        const double share = m.counts[r.work] / (m.ms * 1e6);  // of the time, for each ns of this weight
        double others = 0;
        for (const WorkRow& o : kWork)
          if (o.work != r.work) others += m.counts[o.work] * weights[o.work];
        slope += share * (1 - others / (m.ms * 1e6)), bent += share * share;
      }
      // A turn is what all others are given in, so it is never nothing.
      const double least = r.work == Work::turn ? 1e-3 * begun[r.work] : r.at_least * weights[Work::turn];
      weights[r.work] = std::max(least, slope / bent);
    }
}

}  // namespace

WorkWeights fit_weights(std::span<const MeasuredWork> measured) {
  WorkWeights out = llvmpipe_weights();
  if (measured.empty()) return out;
  std::vector<double> ns_per_unit;
  for (const MeasuredWork& m : measured) ns_per_unit.push_back(m.ms * 1e6 / units_of(m.counts, out));
  WorkCounts ns;
  for (const WorkRow& r : kWork) ns[r.work] = out.units[r.work] * median(ns_per_unit);
  settle(measured, ns);
  out.ns_per_unit = ns[Work::turn];
  for (const WorkRow& r : kWork) out.units[r.work] = ns[r.work] / out.ns_per_unit;
  return out;
}

double median_misfit(std::span<const MeasuredWork> measured, const WorkWeights& weights) {
  std::vector<double> off;
  for (const MeasuredWork& m : measured)
    off.push_back(std::abs(units_of(m.counts, weights) * weights.ns_per_unit / (m.ms * 1e6) - 1));
  return median(std::move(off));
}

}  // namespace gbl
