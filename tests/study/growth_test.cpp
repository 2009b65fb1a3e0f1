// Powers of known curves, and where a fixed cost gives way to one that grows.
#include "renderer/study/rows/growth.h"

#include <cmath>
#include <gtest/gtest.h>

namespace gbl {
namespace {

std::vector<GrowthPoint> curve(double fixed, double each, double power) {
  std::vector<GrowthPoint> out;
  for (const double x : {16, 64, 256, 1024, 4096, 16384}) out.push_back({x, fixed + each * std::pow(x, power)});
  return out;
}

TEST(Growth, PowersAreThoseOfTheCurve) {
  for (const double power : {0.5, 1.0, 2.0})
    for (const double p : growth_powers(curve(0, 3, power))) EXPECT_NEAR(p, power, 1e-12);
  for (const double p : growth_powers(curve(7, 0, 1))) EXPECT_EQ(p, 0);
  EXPECT_TRUE(growth_powers({}).empty());
}

TEST(Growth, BendsWhereTheFixedCostGivesWay) {
  EXPECT_EQ(growth_bend(curve(0, 1, 1)), 16) << "from the beginning";
  EXPECT_EQ(growth_bend(curve(1, 0, 1)), std::nullopt) << "never";
  // 1000 + x: the power between 256 and 1024 is 0.35, between 1024 and 4096 0.67.
  EXPECT_EQ(growth_bend(curve(1000, 1, 1)), 1024);
  const GrowthPoint wavy[] = {{1, 1}, {2, 2}, {4, 2}, {8, 4}};
  EXPECT_EQ(growth_bend(wavy), 4) << "it has to go on";
}

}  // namespace
}  // namespace gbl
