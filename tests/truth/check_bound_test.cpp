#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "renderer/truth/measure.h"
#include "tests/wall_picture.h"

namespace gbl {
namespace {

using namespace test;

TEST(Displayed, FollowsTheSrgbCurve) {
  const Display srgb;
  EXPECT_EQ(displayed(srgb, glm::dvec3(0)), glm::dvec3(0));
  EXPECT_NEAR(displayed(srgb, glm::dvec3(1)).x, 1, 1e-15);
  EXPECT_DOUBLE_EQ(displayed(srgb, glm::dvec3(0.003)).y, 0.003 * 12.92);
  EXPECT_DOUBLE_EQ(displayed(srgb, glm::dvec3(0.2)).z, 1.055 * std::pow(0.2, 1 / 2.4) - 0.055);
  EXPECT_NEAR(displayed(srgb, glm::dvec3(0.21404)).x, 0.5, 1e-5);
}

TEST(Displayed, ExposesThenClampsThenCodes) {
  EXPECT_EQ(displayed(kLinear, {-1, 0.3, 7}), glm::dvec3(0, 0.3, 1));
  EXPECT_EQ(displayed({.exposure = 2, .colour = Colour::as_tutorial}, {0.125, 0.25, 0.75}), glm::dvec3(0.25, 0.5, 1));
  EXPECT_EQ(displayed({.exposure = 2}, glm::dvec3(0.1)), displayed({}, glm::dvec3(0.2)));
  EXPECT_EQ(displayed({}, glm::dvec3(INFINITY)), displayed({}, glm::dvec3(1)));
}

struct Bounded {
  Pair pair = wall({5, 4});
  std::vector<glm::vec3> witness = pair.drawn.lit;
  BoundCheck check() const { return check_bound(pair.truth, pair.drawn.lit, witness, kLinear, 1 / 255.0); }
};

TEST(CheckBound, FindsTheWorstPixel) {
  Bounded b;
  EXPECT_EQ(b.check().over, 0u);
  b.pair.drawn.lit[7].g += 0.125f, b.pair.drawn.lit[13].r -= 0.25f, b.pair.drawn.lit[14].r += 0.002f;
  const BoundCheck c = b.check();
  EXPECT_EQ(c.compared, 20u);
  EXPECT_EQ(c.over, 2u);
  EXPECT_EQ(c.excused, 0u);
  EXPECT_EQ(c.worst, 0.25);
  EXPECT_EQ(c.worst_pixel, glm::ivec2(3, 2));
  EXPECT_EQ(c.share_over(), 0.1);
}

TEST(CheckBound, ExcusesWhereTheWitnessIsOff) {
  Bounded b;
  b.pair.drawn.lit[7] += 0.125f, b.pair.drawn.lit[13] += 0.25f;
  b.witness[13] -= 0.1f, b.witness[2] += 0.1f, b.witness[7] += 0.003f;
  const BoundCheck c = b.check();
  EXPECT_EQ(c.excused, 2u) << "pixel 2 too, where nothing was to be excused";
  EXPECT_EQ(c.over, 1u);
  EXPECT_EQ(c.worst, 0.125);
  EXPECT_EQ(c.worst_pixel, glm::ivec2(2, 1));
}

TEST(CheckBound, NothingHidesAPixelThatIsNotFinite) {
  Bounded b;
  b.pair.truth.lit[6] = glm::dvec3(1), b.witness[6] = glm::vec3(1);
  b.pair.drawn.lit[6] = glm::vec3(kInf), b.pair.drawn.lit[9].r = kNaN, b.pair.drawn.lit[11].r = kNaN;
  b.witness[11].g = kNaN;
  const BoundCheck c = b.check();
  EXPECT_EQ(c.over, 2u);
  EXPECT_EQ(c.excused, 1u);
  EXPECT_EQ(c.worst, INFINITY);
  EXPECT_EQ(c.worst_pixel, glm::ivec2(1, 1)) << "the first of them";
}

TEST(CheckBound, LeavesTheBackgroundOutAndNeedsNoWitness) {
  Bounded b;
  b.pair.truth.present[3] = 0, b.pair.drawn.lit[3] += 0.3f, b.pair.drawn.lit[4] += 0.2f;
  b.witness.clear();
  EXPECT_EQ(b.check().compared, 19u);
  EXPECT_EQ(b.check().over, 1u);
  b.pair.truth.present.assign(20, 0);
  EXPECT_EQ(b.check().compared, 0u);
  EXPECT_EQ(b.check().worst_pixel, glm::ivec2(-1));
  EXPECT_EQ(b.check().share_over(), 0);
}

}  // namespace
}  // namespace gbl
