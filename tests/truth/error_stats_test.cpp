// The numbers of the error view, over errors that are written down here.
#include "renderer/truth/error_stats.h"

#include <gtest/gtest.h>
#include <numeric>

namespace gbl {
namespace {

constexpr float kNone = -1;  // no surface

// Errors of a row of pixels as the GPU gives them: RGBA, r = signed error, a = 1 where a surface is.
std::vector<float> row_of(const std::vector<float>& errors) {
  std::vector<float> out;
  for (const float e : errors) out.insert(out.end(), {e == kNone ? 0 : e, 0, 0, e == kNone ? 0.0f : 1.0f});
  return out;
}

ErrorStats stats_of(const std::vector<float>& errors, double fixed_range = 0) {
  return error_stats(ErrorOf::normal, {static_cast<int>(errors.size()), 1}, row_of(errors), fixed_range);
}

TEST(ErrorStats, MeansAreOverSurfacesOnly) {
  const ErrorStats s = stats_of({0.5f, -0.25f, kNone, 0, -0.75f});
  EXPECT_EQ(s.compared, 4u);
  EXPECT_EQ(s.nonfinite, 0u);
  EXPECT_DOUBLE_EQ(s.mean, 1.5 / 4);
  EXPECT_DOUBLE_EQ(s.signed_mean, -0.5 / 4);
  EXPECT_EQ(s.max, 0.75);
  EXPECT_EQ(s.worst, glm::ivec2(4, 0));
}

TEST(ErrorStats, TheWorstPixelIsCountedFromTheTopAndIsTheFirstOfEquals) {
  // Two rows, the lower one first: only texel (1, 0 from below) is wrong, the second row of the picture.
  const std::vector<float> errors = row_of({0, 2, 0, 1, 0, 1});
  EXPECT_EQ(error_stats(ErrorOf::lit, {3, 2}, errors, 0).worst, glm::ivec2(1, 1));
  EXPECT_EQ(stats_of({0, 0.5f, 0.5f}).worst, glm::ivec2(1, 0));
}

TEST(ErrorStats, WhatIsNoNumberIsTheWorstAndLeftOutOfMeans) {
  const ErrorStats s = stats_of({1, NAN, -INFINITY, 3});
  EXPECT_EQ(s.compared, 4u);
  EXPECT_EQ(s.nonfinite, 2u);
  EXPECT_EQ(s.max, INFINITY);
  EXPECT_EQ(s.worst, glm::ivec2(1, 0));
  EXPECT_EQ(s.mean, 2);
  EXPECT_EQ(s.signed_mean, 2);
  EXPECT_EQ(s.p99, 3);
}

TEST(ErrorStats, WithoutASurfaceThereIsNothing) {
  const ErrorStats s = stats_of({kNone, kNone});
  EXPECT_EQ(s.compared, 0u);
  EXPECT_EQ(s.worst, glm::ivec2(-1));
  EXPECT_EQ(s.max, 0);
  EXPECT_EQ(s.mean, 0);
}

// 2000 errors of which one is huge: the bar fits the others, the histogram's last bin holds what is beyond.
TEST(ErrorStats, TheBarFitsAllButOneInAThousand) {
  std::vector<float> errors(2000, 0);
  for (size_t i = 0; i < 1000; ++i) errors[i] = i % 2 == 0 ? 0.5f : -0.5f;
  errors[7] = 1000;
  const ErrorStats fitted = stats_of(errors);
  EXPECT_EQ(fitted.p99, 0.5);
  EXPECT_GE(fitted.range, 0.5);
  EXPECT_LT(fitted.range, 1);
  EXPECT_EQ(fitted.histogram.front(), 1000u);
  EXPECT_EQ(fitted.histogram.back(), fitted.range == 0.5 ? 1000u : 1u);
  EXPECT_EQ(std::accumulate(fitted.histogram.begin(), fitted.histogram.end(), size_t(0)), fitted.compared);

  const ErrorStats fixed = stats_of(errors, 2);
  EXPECT_EQ(fixed.range, 2);
  EXPECT_EQ(fixed.histogram[ErrorStats::kBins / 4], 999u);
  EXPECT_EQ(fixed.histogram.back(), 1u);

  errors.assign(2000, 0), errors[7] = 3;  // so rare that a fitted bar would end at 0
  EXPECT_GE(stats_of(errors).range, 3);
  EXPECT_EQ(stats_of({0, 0}).range, 1) << "nothing is wrong: any bar will do";
}

std::vector<std::string> labels_of(ErrorScale scale) {
  ErrorStats s;
  s.of = ErrorOf::normal, s.range = 8;
  std::vector<std::string> out;
  for (const LegendEntry& e : error_legend(s, scale).entries)
    if (!e.label.empty()) out.push_back(e.label);
  return out;
}

TEST(ErrorLegend, IsLabelledAtEvenStepsWithTheUnitAtItsEnd) {
  EXPECT_EQ(labels_of(ErrorScale::magnitude), (std::vector<std::string>{"0", "2", "4", "6", "8 degrees"}));
  EXPECT_EQ(labels_of(ErrorScale::with_sign), (std::vector<std::string>{"-8", "0", "8 degrees"}));
}

TEST(ErrorLegend, NamesWhatIsNoNumberOnlyWhereThereIsSome) {
  ErrorStats s;
  EXPECT_EQ(error_legend(s, ErrorScale::magnitude).apart.size(), 1u);
  s.nonfinite = 1;
  ASSERT_EQ(error_legend(s, ErrorScale::magnitude).apart.size(), 2u);
  EXPECT_EQ(error_legend(s, ErrorScale::magnitude).apart[1].label, "not finite");
}

}  // namespace
}  // namespace gbl
