// Weights are found again from the times that they make, whatever the device; what is not measured stays in proportion.
#include "renderer/frame/weight_fit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "renderer/base/random.h"

namespace gbl {
namespace {

// A device 30 times as fast, and unlike llvmpipe in each kind of work.
WorkWeights some_device(Pcg32& random) {
  WorkWeights w = llvmpipe_weights();
  for (const WorkRow& r : kWork)
    if (r.work != Work::turn) w.units[r.work] = std::max(r.at_least, w.units[r.work] * std::exp(random.in(-1.5, 1.5)));
  w.ns_per_unit = 0.06;
  return w;
}

// As a frame might have them: each kind in some of the set-ups, in amounts that take about as long as each other.
std::vector<MeasuredWork> measured_with(const WorkWeights& w, Pcg32& random, double noise, Work unused = Work::turn) {
  std::vector<MeasuredWork> out;
  for (int i = 0; i < 80; ++i) {
    MeasuredWork m;
    for (const WorkRow& r : kWork)
      if ((random.next() % 3 == 0 || r.work == Work::turn) && (r.work != unused || unused == Work::turn))
        m.counts[r.work] = 1e6 / r.llvmpipe * std::exp(random.in(-2, 2));
    m.ms = units_of(m.counts, w) * w.ns_per_unit * 1e-6 * (1 + random.in(-noise, noise));
    out.push_back(m);
  }
  return out;
}

TEST(WeightFit, FindsTheWeightsThatMadeTheTimes) {
  Pcg32 random(1);
  for (int device = 0; device < 5; ++device) {
    const WorkWeights truth = some_device(random);
    const std::vector<MeasuredWork> measured = measured_with(truth, random, 0);
    const WorkWeights found = fit_weights(measured);
    EXPECT_NEAR(found.ns_per_unit, truth.ns_per_unit, 0.03 * truth.ns_per_unit);  // the prior draws a little
    for (const WorkRow& r : kWork)
      EXPECT_NEAR(found.units[r.work] / truth.units[r.work], 1, 0.1) << device << ": " << r.id;
    EXPECT_LT(median_misfit(measured, found), 0.01);
    EXPECT_GT(median_misfit(measured, llvmpipe_weights()), 0.5) << "of another device, and without its clock";
  }
}

TEST(WeightFit, NoiseIsAveragedAndNoWeightFallsBelowWhatItHolds) {
  Pcg32 random(2);
  const WorkWeights truth = some_device(random);
  const std::vector<MeasuredWork> measured = measured_with(truth, random, 0.2);
  const WorkWeights found = fit_weights(measured);
  EXPECT_LT(median_misfit(measured, found), 0.2);
  for (const WorkRow& r : kWork) EXPECT_GE(found.units[r.work], r.at_least * (1 - 1e-12)) << r.id;
  EXPECT_EQ(found.units[Work::turn], 1);
}

TEST(WeightFit, WhatNoSetUpHasStaysInItsProportion) {
  Pcg32 random(3);
  WorkWeights truth = llvmpipe_weights();
  truth.ns_per_unit = 0.5;
  const WorkWeights found = fit_weights(measured_with(truth, random, 0, Work::disc));
  EXPECT_NEAR(found.units[Work::disc], truth.units[Work::disc], 0.05 * truth.units[Work::disc]);
  EXPECT_EQ(fit_weights({}), llvmpipe_weights());
}

}  // namespace
}  // namespace gbl
