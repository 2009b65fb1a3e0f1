#include "renderer/inspect/view_stats.h"

#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <vector>

namespace gbl {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

TEST(ViewStats, LeavesTheBackgroundAndWhatIsNoNumberOut) {
  const std::vector<glm::vec4> values = {{400, 0, 0, 1},  {600, 0, 0, 1},  {500, 9, 9, 1}, {1e9f, 0, 0, 0},
                                         {kNan, 0, 0, 1}, {kInf, 0, 0, 1}, {-1, 0, 0, 0}};
  const ViewStats s = view_stats(values, 1);
  EXPECT_EQ(s.pixels, 5u);
  EXPECT_EQ(s.nonfinite, 2u);
  EXPECT_EQ(s.negative, 0u);
  EXPECT_EQ(s.min.x, 400);
  EXPECT_EQ(s.max.x, 600);
  EXPECT_EQ(s.mean.x, 500);
  EXPECT_EQ(fitted_range(s, 1, "rgb"), glm::dvec2(400, 600)) << "near and far";
  ViewStats three;
  three.min = {0, -1, 400}, three.max = {8, 1, 600};
  EXPECT_EQ(fitted_range(three, 3, "b"), glm::dvec2(400, 600)) << "of the channels that are shown";
  EXPECT_EQ(fitted_range(three, 3, "rg"), glm::dvec2(-1, 9)) << "round numbers";
  EXPECT_EQ(std::accumulate(s.bins[0].begin(), s.bins[0].end(), 0u), 3u);
  EXPECT_EQ(s.bins[0][0], 1u);
  EXPECT_EQ(s.bins[0][32], 1u);
  EXPECT_EQ(s.bins[0][63], 1u);
  EXPECT_EQ(view_stats({}, 3).pixels, 0u);
}

TEST(ViewStats, AFittedBarHoldsAllAndWastesLittle) {
  for (const auto& [least, most] : {std::pair{0.0, 1.0},
                                    {352.3, 371.0},
                                    {-1.0, 1.0},
                                    {-0.003, 0.002},
                                    {1e6, 1e6 + 1},
                                    {3443.0, 3444.0},
                                    {0.0, 3443.0}}) {
    const glm::dvec2 bar = round_range(least, most);
    EXPECT_LE(bar.x, least);
    EXPECT_GE(bar.y, most);
    EXPECT_LE(bar.y - bar.x, 2.3 * (most - least)) << least << " " << most;
  }
  for (const double alike : {0.0, 5.0, -2.0}) {
    const glm::dvec2 bar = round_range(alike, alike);
    EXPECT_LT(bar.x, alike);
    EXPECT_GT(bar.y, alike);
  }
}

TEST(ViewStats, SamplesCoverThePictureAndAreFew) {
  for (const glm::ivec2 size :
       {glm::ivec2(1, 1), glm::ivec2(320, 180), glm::ivec2(1280, 720), glm::ivec2(3840, 2160), glm::ivec2(17, 16384)}) {
    const PixelGrid g = sample_grid(size);
    EXPECT_LE(g.pixels(), 65536u);
    const glm::ivec2 last = g.first + (g.count - 1) * g.step;
    EXPECT_LT(last.x, size.x);
    EXPECT_LT(last.y, size.y);
    EXPECT_GE(last.x + g.step.x, size.x);
    EXPECT_GE(last.y + g.step.y, size.y);
  }
}

}  // namespace
}  // namespace gbl
