// The numbers of the error view, over errors that are written down here.
#include "renderer/truth/error_stats.h"

#include <gtest/gtest.h>
#include <numeric>

#include "renderer/truth/colour_spaces.h"

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

// 2 x 2 pixels, the lower row first; all show object 2, triangle 7.
std::vector<float> of_four(float e0, float e1, float e2, float e3) {
  return {e0, 2, 7, 1, e1, 2, 7, 1, e2, 2, 7, 1, e3, 2, 7, 1};
}

TEST(ErrorStats, TiesAreLeftOutOfTheLargestAlone) {
  Truth truth{.size = {2, 2}};
  truth.rivals = {{0, {2, 7}}, {1, {2, 8}}, {2, {3, 7}}, {3, {2, 7}}};
  std::vector<float> errors = of_four(0.25f, NAN, 9, 0.5f);
  EXPECT_TRUE(mark_ties(truth, errors));
  EXPECT_EQ(errors[8 + 3], kTie) << "the upper left one shows what is seen beside it";
  for (const size_t i : {0, 1, 3}) EXPECT_EQ(errors[4 * i + 3], 1) << i;
  const ErrorStats s = error_stats(ErrorOf::normal, {2, 2}, errors, 0);
  EXPECT_EQ(s.compared, 4u);
  EXPECT_EQ(s.ties, 1u);
  EXPECT_EQ(s.nonfinite, 1u) << "at an edge, too, it is no number";
  EXPECT_EQ(s.worst, glm::ivec2(1, 1));
  EXPECT_DOUBLE_EQ(s.mean, 9.75 / 3);

  errors = of_four(0.25f, 0.125f, 9, 0.5f);
  mark_ties(truth, errors);
  const ErrorStats finite = error_stats(ErrorOf::normal, {2, 2}, errors, 0);
  EXPECT_EQ(finite.ties, 2u);
  EXPECT_EQ(finite.max, 0.5);
  EXPECT_EQ(finite.worst, glm::ivec2(1, 0));

  truth.rivals.clear();
  errors = of_four(0.25f, 0.125f, 9, 0.5f);
  EXPECT_FALSE(mark_ties(truth, errors));
  EXPECT_EQ(error_stats(ErrorOf::normal, {2, 2}, errors, 0).max, 9);
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
  s.ties = 1;
  EXPECT_EQ(error_legend(s, ErrorScale::magnitude).apart[1].label, "edge: either surface");
}

// Machado, Oliveira and Fernandes 2009, "A Physiologically-based Model for Simulation of Color Vision Deficiency", of
// linear colours, at full severity; and nobody's.
constexpr double kSight[][9] = {
    {1, 0, 0, 0, 1, 0, 0, 0, 1},
    {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
    {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
    {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}};

glm::dvec3 lab_as_seen(const double (&sight)[9], const glm::vec3& srgb) {
  const glm::dvec3 linear = linear_from_srgb(glm::dvec3(srgb));
  glm::dvec3 seen(0);
  for (int k = 0; k < 9; ++k) seen[k / 3] += sight[k] * linear[k % 3];
  return lab_from_xyz(xyz_from_linear_srgb() * glm::clamp(seen, 0.0, 1.0));
}

// 2.3 is a just noticeable difference; here are thirty, one pixel being small.
TEST(ErrorLegend, TiesLookLikeNothingElseToNobody) {
  for (const ErrorScale scale : {ErrorScale::magnitude, ErrorScale::with_sign}) {
    ErrorStats s;
    s.nonfinite = 1;
    const Legend bar = error_legend(s, scale);
    std::vector<glm::vec3> others = {bar.apart[0].colour, bar.apart[1].colour};
    for (size_t i = 0; i + 1 < bar.entries.size(); ++i)
      for (const float t : {0.0f, 0.5f, 1.0f})
        others.push_back(glm::mix(bar.entries[i].colour, bar.entries[i + 1].colour, t));
    for (const auto& sight : kSight)
      for (const glm::vec3& other : others)
        EXPECT_GT(glm::distance(lab_as_seen(sight, kTieColour), lab_as_seen(sight, other)), 30)
            << &sight - kSight << ": " << other.r << " " << other.g << " " << other.b;
  }
}

}  // namespace
}  // namespace gbl
