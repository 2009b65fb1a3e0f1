#include "renderer/truth/measure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "renderer/truth/flip.h"
#include "renderer/truth/tally.h"
#include "tests/wall_picture.h"

namespace gbl {
namespace {

using namespace test;

Errors shifted(float shift) {
  Pair p = wall({20, 10});
  for (glm::vec3& lit : p.drawn.lit) lit += shift;
  return measured(p);
}

// ---- columns --------------------------------------------------------------------------------------------------------

TEST(ErrorColumns, HaveIdsOfTheirOwnAndAreAllReached) {
  std::set<std::string> ids;
  const Errors e = measured(wall({4, 4}));
  for (const ErrorColumn& c : error_columns()) {
    EXPECT_TRUE(ids.insert(c.id).second) << c.id;
    EXPECT_TRUE((e.*c.value).has_value()) << c.id;
  }
  EXPECT_EQ(sizeof(Errors), ids.size() * sizeof(std::optional<double>)) << "a number that no column shows";
}

TEST(Measure, EqualPicturesHaveNoError) {
  const Errors e = measured(wall({20, 10}));
  for (const ErrorColumn& c : error_columns()) {
    const std::string id = c.id;
    if (id == "psnr_display")
      EXPECT_EQ(e.*c.value, INFINITY);
    else
      EXPECT_EQ(e.*c.value, id == "compared_pixels" ? 200 : 0) << id;
  }
}

TEST(Measure, ASteadyShiftIsItsOwnMean) {
  for (const float shift : {0.1f, -0.1f}) {
    const Errors e = shifted(shift);
    EXPECT_NEAR(*e.mae_linear, 0.1, 1e-7);
    EXPECT_NEAR(*e.rmse_linear, 0.1, 1e-7);
    EXPECT_NEAR(*e.signed_mean_linear, shift, 1e-7);
    EXPECT_NEAR(*e.max_linear, 0.1, 1e-7);
    EXPECT_NEAR(*e.p99_linear, 0.1, 1e-7);
    EXPECT_NEAR(*e.relmse_linear, 0.01 / 0.26, 1e-7);
    EXPECT_NEAR(*e.psnr_display, 20, 1e-5);
    EXPECT_EQ(e.over_1_255_display, 1);
    EXPECT_GT(*e.flip_mean, 0);
  }
}

TEST(Measure, SharesTellHalfACodeFromAWholeOne) {
  const Errors e = shifted(0.7f / 255);
  EXPECT_EQ(e.over_1_255_display, 0);
  EXPECT_EQ(e.over_half_255_display, 1);
  EXPECT_EQ(e.over_1_255_linear, 0);
  EXPECT_EQ(shifted(0.4f / 255).over_half_255_display, 0);
}

TEST(Measure, OneWrongPixelShowsInMaximumAndSharesWherePsnrFlatters) {
  Pair p = wall({100, 50});
  p.drawn.lit[777].g = 1;
  const Errors e = measured(p);
  const double n = 5000;
  EXPECT_DOUBLE_EQ(*e.over_1_255_display, 1 / n);
  EXPECT_DOUBLE_EQ(*e.over_1_255_linear, 1 / n);
  EXPECT_EQ(e.max_linear, 0.5);
  EXPECT_EQ(e.p99_linear, 0);
  EXPECT_DOUBLE_EQ(*e.mae_linear, 0.5 / (3 * n));
  EXPECT_DOUBLE_EQ(*e.rmse_linear, std::sqrt(0.25 / (3 * n)));
  EXPECT_GT(*e.psnr_display, 45);
  EXPECT_GT(*e.flip_mean, 0);
  EXPECT_LT(*e.flip_mean, 0.02);
}

TEST(Measure, PercentilesAreValuesOfNearestRank) {
  Pair p = wall({20, 10});
  for (int i = 0; i < 200; ++i) p.drawn.lit[size_t(199 - i)] += float(i) / 1024;  // exact in float: 0 .. 199 / 1024
  EXPECT_EQ(measured(p).p99_linear, 197 / 1024.0) << "the 198th of 200";
  Tally t;
  for (const double v : {5, 1, 4, 2, 3}) t.add(v);
  EXPECT_EQ(t.percentile(0.5), 3);
  EXPECT_EQ(t.percentile(0.2), 1);
  EXPECT_EQ(t.percentile(0.21), 2);
  EXPECT_EQ(t.percentile(1), 5);
  EXPECT_EQ(Tally().percentile(0.5), std::nullopt);
}

TEST(Measure, LeavesTheUnseenOut) {
  Pair p = wall({20, 10});
  for (size_t i = 0; i < 100; ++i) {
    p.truth.present[i] = 0;
    p.drawn.normal[i] = glm::vec3(0), p.drawn.position[i] = glm::vec3(9);
    p.drawn.lit[i] += 0.003f;  // below one code
  }
  const Errors e = measured(p);
  EXPECT_EQ(e.compared_pixels, 100);
  for (const auto column : {&Errors::max_linear, &Errors::normal_deg_max, &Errors::position_max, &Errors::lost_pixels,
                            &Errors::background_lit_pixels})
    EXPECT_EQ(e.*column, 0);
}

TEST(Measure, WhatIsDrawnForwardIsCountedAndNotJudged) {
  Pair p = wall({20, 10});
  for (size_t i = 0; i < 30; ++i) p.drawn.shown[i] += 0.5f;
  const Errors e = measured(p);
  EXPECT_EQ(e.blended_pixels, 30);
  EXPECT_EQ(e.max_linear, 0);
}

TEST(Measure, FlipSeesTheWholePictureAndAveragesTheSurfaces) {
  Pair p = wall({30, 20});
  for (size_t i = 300; i < 600; ++i) p.truth.present[i] = 0, p.drawn.lit[i] = glm::vec3(1);
  const Errors e = measured(p);
  EXPECT_EQ(e.max_linear, 0);
  std::vector<glm::dvec3> drawn;
  for (const glm::vec3& lit : p.drawn.lit) drawn.emplace_back(lit);
  const std::vector<double> map = flip(p.truth.size, p.truth.lit, drawn);
  double sum = 0;
  for (size_t i = 0; i < 300; ++i) sum += map[i];
  EXPECT_DOUBLE_EQ(*e.flip_mean, sum / 300);
  EXPECT_GT(sum, 0) << "the bright background is seen beside the wall";
}

TEST(Measure, WithoutASurfaceThereIsNothingToMeasure) {
  Pair p = wall({4, 4});
  p.truth.present.assign(16, 0);
  p.drawn.lit[3] = glm::vec3(kNaN), p.drawn.lit[4] = glm::vec3(0.5f, 0.5f, 0.6f), p.drawn.lit[5] = glm::vec3(0.4f);
  const Errors e = measured(p);
  const std::set<std::string> given = {"compared_pixels",       "tie_pixels",
                                       "nonfinite_pixels",      "background_lit_pixels",
                                       "background_off_pixels", "blended_pixels"};
  for (const ErrorColumn& c : error_columns()) EXPECT_EQ((e.*c.value).has_value(), given.contains(c.id)) << c.id;
  EXPECT_EQ(e.compared_pixels, 0);
  EXPECT_EQ(e.nonfinite_pixels, 1);
  EXPECT_EQ(e.background_lit_pixels, 1) << "lit, not darkened";
  EXPECT_EQ(e.background_off_pixels, 3) << "too dark is as wrong as lit, and so is no number";
}

// Pixel 3 shows what the reference sees beside it, pixel 4 what it sees nowhere, pixel 5 what it sees beside another.
TEST(Measure, TiesAreCountedAndLeftOutOfMaximaAlone) {
  Pair p = wall({20, 10});
  p.truth.rivals = {{3, {2, 7}}, {4, {2, 7}}};
  p.drawn.seen[3] = {2, 7}, p.drawn.seen[4] = {2, 8}, p.drawn.seen[5] = {2, 7};
  const auto spoil = [&](size_t i, float by) {
    p.drawn.lit[i] += by, p.drawn.position[i].x += by, p.drawn.normal[i] = glm::vec3(by, 0, 1);
  };
  spoil(3, 4), spoil(4, 0.25f);
  Errors e = measured(p);
  EXPECT_EQ(e.tie_pixels, 1);
  EXPECT_EQ(e.max_linear, 0.25);
  EXPECT_EQ(e.position_max, 0.25);
  EXPECT_NEAR(*e.normal_deg_max, glm::degrees(std::atan(0.25)), 1e-6);
  EXPECT_EQ(e.compared_pixels, 200);
  EXPECT_DOUBLE_EQ(*e.mae_linear, 4.25 / 200);
  EXPECT_DOUBLE_EQ(*e.position_mean, 4.25 / 200);
  EXPECT_EQ(e.over_1_255_linear, 2 / 200.0);

  p.drawn.lit[3].g = kNaN;
  EXPECT_EQ(measured(p).max_linear, INFINITY) << "no edge makes a number of it";
  p.drawn.seen.clear();
  e = measured(p);
  EXPECT_EQ(e.tie_pixels, std::nullopt) << "what the frame shows is not known";
  EXPECT_EQ(e.position_max, 4) << "so nothing is excused";
}

TEST(Measure, APixelWithoutASurfaceIsNoTie) {
  Pair p = wall({4, 4});
  p.truth.rivals = {{3, {2, 7}}}, p.drawn.seen[3] = {2, 7}, p.truth.present[3] = 0;
  EXPECT_EQ(measured(p).tie_pixels, 0);
}

TEST(Measure, WhatIsNotStoredIsNotJudged) {
  Pair p = wall({4, 4});
  p.drawn = {};
  for (const ErrorColumn& c : error_columns())
    EXPECT_EQ((measured(p).*c.value).has_value(), std::string(c.id) == "compared_pixels") << c.id;
  p = wall({4, 4});
  p.drawn.unlit.clear();
  EXPECT_EQ(measured(p).lost_pixels, std::nullopt);
  EXPECT_EQ(measured(p).doubled_pixels, std::nullopt);
  EXPECT_EQ(measured(p).max_linear, 0);
}

TEST(Measure, JudgesWhatTheScreenShows) {
  Pair p = wall({4, 4});
  p.truth.lit.assign(16, glm::dvec3(2)), p.drawn.lit.assign(16, glm::vec3(3));
  EXPECT_EQ(measured(p, {}).over_half_255_display, 0) << "both white";
  EXPECT_EQ(measured(p, {}).over_1_255_linear, 1);
  EXPECT_EQ(measured(p, {.exposure = 0.25}).over_1_255_display, 1);
  p.truth.lit.assign(16, glm::dvec3(0)), p.drawn.lit.assign(16, glm::vec3(0.001f));
  EXPECT_EQ(measured(p, kLinear).over_1_255_display, 0);
  EXPECT_EQ(measured(p, {}).over_1_255_display, 1) << "the curve is steep in the dark";
}

// ---- not finite -----------------------------------------------------------------------------------------------------

TEST(Measure, PixelsThatAreNotFiniteAreNeverAveragedAway) {
  for (const float bad : {kNaN, kInf, -kInf}) {
    Pair p = wall({20, 10});
    for (glm::vec3& lit : p.drawn.lit) lit += 0.125f;
    p.drawn.lit[7].b = bad, p.drawn.lit[8].r = bad;
    const Errors e = measured(p);
    EXPECT_EQ(e.nonfinite_pixels, 2);
    EXPECT_EQ(e.max_linear, INFINITY);
    EXPECT_EQ(e.mae_linear, 0.125);
    EXPECT_EQ(e.signed_mean_linear, 0.125);
    EXPECT_EQ(e.rmse_linear, 0.125);
    EXPECT_EQ(e.p99_linear, 0.125);
    EXPECT_NEAR(*e.psnr_display, -20 * std::log10(0.125), 1e-9);
    EXPECT_EQ(e.over_1_255_linear, 1);
    EXPECT_TRUE(std::isfinite(*e.flip_mean));
    EXPECT_GE(*e.flip_mean, 2.0 / 200);
  }
}

TEST(Measure, PixelsThatAreNotFiniteAreOverEveryBound) {
  Pair p = wall({20, 10});
  p.truth.lit.assign(200, glm::dvec3(1)), p.drawn.lit.assign(200, glm::vec3(1));
  p.drawn.lit[7] = glm::vec3(kInf);                                  // clamped it would look right
  p.truth.lit[8] = glm::dvec3(0), p.drawn.lit[8] = glm::vec3(kNaN);  // and this one as black
  const Errors e = measured(p);
  for (const auto column : {&Errors::over_1_255_display, &Errors::over_half_255_display, &Errors::over_1_255_linear})
    EXPECT_EQ(e.*column, 0.01);
  EXPECT_EQ(e.psnr_display, INFINITY) << "of the others";
}

TEST(Measure, NoFinitePixelLeavesNoMean) {
  Pair p = wall({4, 4});
  p.drawn.lit.assign(16, glm::vec3(kNaN)), p.drawn.position.assign(16, glm::vec3(kInf));
  const Errors e = measured(p);
  for (const auto column : {&Errors::mae_linear, &Errors::rmse_linear, &Errors::p99_linear, &Errors::psnr_display,
                            &Errors::signed_mean_linear, &Errors::relmse_linear, &Errors::position_mean})
    EXPECT_EQ(e.*column, std::nullopt);
  for (const auto column : {&Errors::over_1_255_display, &Errors::over_1_255_linear, &Errors::flip_mean})
    EXPECT_EQ(e.*column, 1);
  EXPECT_EQ(e.nonfinite_pixels, 16);
  EXPECT_EQ(e.max_linear, INFINITY);
  EXPECT_EQ(e.position_max, INFINITY);
}

// ---- normals and positions ------------------------------------------------------------------------------------------

// The wall's first pixel with this normal.
Errors with_normal(const glm::vec3& n) {
  Pair p = wall({10, 1});
  p.drawn.normal[0] = n;
  return measured(p);
}

TEST(Normals, SmallAnglesAreResolved) {
  for (const double deg : {1e-6, 1e-4, 0.01, 1.0, 89.0, 120.0, 180.0}) {
    const double rad = glm::radians(deg);
    const Errors e = with_normal(glm::vec3(std::sin(rad), 0, std::cos(rad)));
    EXPECT_NEAR(*e.normal_deg_max, deg, 1e-5 * deg) << deg;
    EXPECT_NEAR(*e.normal_deg_mean, deg / 10, 1e-6 * deg) << deg;
    EXPECT_EQ(e.normal_deg_p50, 0);
    EXPECT_EQ(e.normal_deg_p99, e.normal_deg_max);
  }
}

TEST(Normals, LengthIsNoAngle) {
  EXPECT_EQ(with_normal({0, 0, 0.5f}).normal_deg_max, 0);
  EXPECT_EQ(with_normal({0, 0, 1e-30f}).normal_deg_max, 0);
  EXPECT_NEAR(*with_normal({3, 0, 3}).normal_deg_max, 45, 1e-12);
}

TEST(Normals, NoDirectionIsTheOppositeOne) {
  for (const glm::vec3& n : {glm::vec3(0), glm::vec3(kNaN, 0, 1), glm::vec3(0, 0, kInf), glm::vec3(0, 0, -1)}) {
    EXPECT_EQ(with_normal(n).normal_deg_max, 180);
    EXPECT_EQ(with_normal(n).normal_deg_mean, 18);
    EXPECT_EQ(with_normal(n).nonfinite_pixels, 0) << "of lit, which is sound";
  }
}

TEST(Positions, AreDistancesAlsoFarAway) {
  Pair p = wall({10, 1});
  p.truth.position.assign(10, glm::dvec3(1e7, 0, -1e7)), p.drawn.position.assign(10, glm::vec3(1e7f, 0, -1e7f));
  p.truth.position[4] += glm::dvec3(0.0003, 0, 0.0004);
  const Errors e = measured(p);
  EXPECT_NEAR(*e.position_max, 0.0005, 1e-8);
  EXPECT_NEAR(*e.position_mean, 0.00005, 1e-9);
  EXPECT_EQ(e.position_p99, e.position_max);
}

TEST(Positions, OneThatIsNotFiniteMakesTheMaximumInfinite) {
  Pair p = wall({10, 1});
  for (glm::vec3& at : p.drawn.position) at.x += 0.5f;
  p.drawn.position[2].z = kNaN;
  const Errors e = measured(p);
  EXPECT_EQ(e.position_max, INFINITY);
  EXPECT_EQ(e.position_mean, 0.5);
  EXPECT_EQ(e.position_p99, 0.5);
}

}  // namespace
}  // namespace gbl
