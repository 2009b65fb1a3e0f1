// The rule by which a long run is judged.
#include "tests/flatness.h"

#include <gtest/gtest.h>

#include "tests/sanitized.h"

namespace gbl::test {
namespace {

std::vector<double> records(int n, double (*at)(int)) {
  std::vector<double> out;
  for (int k = 0; k < n; ++k) out.push_back(at(k));
  return out;
}

TEST(Flatness, WhatFillsInTheFirstThirdIsNoGrowth) {
  EXPECT_EQ(growth(records(30, [](int k) { return k < 10 ? 100.0 + 10 * k : 200.0; })), 0);
}

TEST(Flatness, ALeakIsASlope) {
  EXPECT_GT(growth(records(30, [](int k) { return 100.0 + 0.2 * k; })), 0.02);
  EXPECT_LT(growth(records(30, [](int k) { return 100.0 - 0.2 * k; })), -0.02);
}

TEST(Flatness, OneRecordThatIsOffSaysNothing) {
  EXPECT_EQ(growth(records(30, [](int k) { return k == 29 ? 300.0 : 100.0; })), 0);
}

TEST(Flatness, AProcessHoldsWhatItHasTouched) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer's shadows count, too";
  const double before = resident_mib(getpid());
  const std::vector<char> touched(64 << 20, 'x');
  EXPECT_NEAR(resident_mib(getpid()) - before, 64, 2) << touched.back();
}

}  // namespace
}  // namespace gbl::test
