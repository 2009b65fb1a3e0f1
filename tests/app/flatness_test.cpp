// The rule by which a long run is judged.
#include "tests/flatness.h"

#include <gtest/gtest.h>

#include "tests/sanitized.h"

namespace gbl::test {
namespace {

std::vector<Sample> samples(int n, double (*at)(int)) {
  std::vector<Sample> out;
  for (int k = 0; k < n; ++k) out.push_back({10.0 * k, at(k)});
  return out;
}

TEST(Flatness, WhatFillsInTheFirstThirdIsNoGrowth) {
  EXPECT_EQ(growth(samples(30, [](int k) { return k < 10 ? 100.0 + 10 * k : 200.0; })), 0);
}

// A cycle that takes ten times as long as those before is as much of the run as all of them.
TEST(Flatness, AThirdIsOneOfTheTime) {
  const std::vector<Sample> slower = {{10, 1}, {20, 2}, {30, 3}, {130, 9}, {230, 9}, {330, 9}, {430, 9}};
  EXPECT_EQ(after_warm_up(slower).size(), 3u);
  EXPECT_EQ(growth(slower), 0);
}

TEST(Flatness, ALeakIsASlope) {
  EXPECT_GT(growth(samples(30, [](int k) { return 100.0 + 0.2 * k; })), 0.02);
  EXPECT_LT(growth(samples(30, [](int k) { return 100.0 - 0.2 * k; })), -0.02);
}

TEST(Flatness, OneRecordThatIsOffSaysNothing) {
  EXPECT_EQ(growth(samples(30, [](int k) { return k == 29 ? 300.0 : 100.0; })), 0);
}

TEST(Flatness, AProcessHoldsWhatItHasTouched) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer's shadows count, too";
  const double before = resident_mib(getpid());
  const std::vector<char> touched(64 << 20, 'x');
  EXPECT_NEAR(resident_mib(getpid()) - before, 64, 2) << touched.back();
}

}  // namespace
}  // namespace gbl::test
