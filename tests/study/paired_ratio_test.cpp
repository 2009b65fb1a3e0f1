#include "renderer/study/rows/paired_ratio.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "renderer/base/random.h"

namespace gbl {
namespace {

TEST(PairedRatio, DriftThatSlowsBothDownChangesNothing) {
  std::vector<double> a, b;
  for (int i = 0; i < 21; ++i) a.push_back(10 + i), b.push_back(5 + 0.5 * i);
  const PairedRatio r = paired_ratio(a, b);
  EXPECT_DOUBLE_EQ(r.median, 0.5);
  EXPECT_DOUBLE_EQ(r.low, 0.5);
  EXPECT_DOUBLE_EQ(r.high, 0.5);
}

TEST(PairedRatio, OfFewRoundsTheIntervalIsAllThatWasSeen) {
  const std::vector<double> a{1, 1, 1, 1}, b{4, 1, 2, 3};
  const PairedRatio r = paired_ratio(a, b);
  EXPECT_DOUBLE_EQ(r.median, 2.5);
  EXPECT_DOUBLE_EQ(r.low, 1);
  EXPECT_DOUBLE_EQ(r.high, 4);
}

// In 95 of 100 experiments the true ratio lies in the interval, or somewhat more: ranks are whole numbers.
TEST(PairedRatio, TheIntervalHoldsTheTrueRatioAsOftenAsItSays) {
  Pcg32 random(5);
  for (const int rounds : {9, 21, 60}) {
    int held = 0;
    constexpr int kExperiments = 4000;
    for (int k = 0; k < kExperiments; ++k) {
      std::vector<double> a, b;
      for (int i = 0; i < rounds; ++i) {
        const double slow = std::exp(random.in(0, 1));  // of the whole round
        a.push_back(slow * std::exp(random.in(-0.2, 0.2)));
        b.push_back(slow * 0.8 * std::exp(random.in(-0.2, 0.2)));
      }
      const PairedRatio r = paired_ratio(a, b);
      held += r.low <= 0.8 && 0.8 <= r.high;
    }
    EXPECT_GT(held, 0.945 * kExperiments) << rounds;  // three standard errors below 0.955, the least of these ranks
    EXPECT_LT(held, 0.998 * kExperiments) << rounds;  // of nine all are taken: 1 - 2 / 2^9
  }
}

}  // namespace
}  // namespace gbl
