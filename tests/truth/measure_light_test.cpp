#include <gtest/gtest.h>

#include "renderer/truth/measure.h"
#include "tests/wall_picture.h"

namespace gbl {
namespace {

using namespace test;

// Draws the wall's first pixel with this light instead of 0.25.
Errors with_light(const glm::vec3& light, const glm::dvec3& expected = glm::dvec3(0.25)) {
  Pair p = wall({4, 4});
  p.truth.diffuse[0] = expected / p.truth.albedo[0];
  p.drawn.lit[0] = p.drawn.unlit[0] + light;
  return measured(p);
}

TEST(LostAndDoubled, AreJudgedByTheRatioOfTheLightAlone) {
  EXPECT_EQ(with_light(glm::vec3(0.13f)).lost_pixels, 0);
  EXPECT_EQ(with_light(glm::vec3(0.12f)).lost_pixels, 1);
  EXPECT_EQ(with_light(glm::vec3(0)).lost_pixels, 1);
  EXPECT_EQ(with_light(glm::vec3(0.37f)).doubled_pixels, 0);
  EXPECT_EQ(with_light(glm::vec3(0.38f)).doubled_pixels, 1);
  EXPECT_EQ(with_light(glm::vec3(0.38f)).lost_pixels, 0);
}

TEST(LostAndDoubled, LeaveOutWhatNobodySees) {
  const glm::dvec3 dim(0.9 / 255);
  EXPECT_EQ(with_light(glm::vec3(0), dim).lost_pixels, 0);
  EXPECT_EQ(with_light(glm::vec3(1.8f / 255), dim).doubled_pixels, 0) << "less than a code too much";
  EXPECT_EQ(with_light(glm::vec3(2.0f / 255), dim).doubled_pixels, 1);
}

TEST(LostAndDoubled, LookAtTheChannelThatShouldBeBrightest) {
  const glm::dvec3 green(0.05, 0.3, 0.1);
  EXPECT_EQ(with_light({0.05f, 0, 0.1f}, green).lost_pixels, 1);
  EXPECT_EQ(with_light({0, 0.3f, 0}, green).lost_pixels, 0);
  EXPECT_EQ(with_light({0, 0, 0.1f}, glm::dvec3(0)).doubled_pixels, 1) << "light where none should be";
}

TEST(LostAndDoubled, CountSpecularLightAndNoPixelThatIsNotFinite) {
  Pair p = wall({4, 4});
  p.truth.specular[2] = glm::dvec3(0.5);
  EXPECT_EQ(measured(p).lost_pixels, 1) << "0.25 of 0.75";
  p = wall({4, 4});
  p.drawn.lit[0] = glm::vec3(kInf), p.drawn.lit[1] = glm::vec3(-kInf), p.drawn.lit[2] = glm::vec3(kNaN);
  EXPECT_EQ(measured(p).lost_pixels, 0);
  EXPECT_EQ(measured(p).doubled_pixels, 0);
  EXPECT_EQ(measured(p).nonfinite_pixels, 3);
}

// The wall's light is 0.25; without shadows 1 would arrive.
TEST(WrongShadows, AreCountedLitAndDarkApartByWhatWouldArrive) {
  const auto with = [](const glm::vec3& light, double unshadowed) {
    Pair p = wall({4, 4});
    p.truth.unshadowed.assign(p.truth.pixels(), glm::dvec3(unshadowed));
    p.drawn.lit[0] = p.drawn.unlit[0] + light;
    return measured(p);
  };
  EXPECT_EQ(with(glm::vec3(0.49f), 1).shadow_lit_pixels, 0);
  EXPECT_EQ(with(glm::vec3(0.51f), 1).shadow_lit_pixels, 1);
  EXPECT_EQ(with(glm::vec3(0.51f), 1).shadow_dark_pixels, 0);
  EXPECT_EQ(with(glm::vec3(0.02f), 0.8).shadow_dark_pixels, 1);
  EXPECT_EQ(with(glm::vec3(0.06f), 0.8).shadow_dark_pixels, 0);
  EXPECT_EQ(with(glm::vec3(0.02f), 0.8).shadow_lit_pixels, 0);
  EXPECT_EQ(with(glm::vec3(kNaN), 1).shadow_lit_pixels, 0);
  Pair p = wall({4, 4});
  p.truth.unshadowed.clear();
  EXPECT_FALSE(measured(p).shadow_lit_pixels) << "no light has a shadow: nothing is judged";
}

// The right half is in shadow, and its edge is drawn one pixel too far to the right in three rows of four.
TEST(WrongShadows, EdgesAreOffByWrongPixelsForEachOfTheTrueEdge) {
  Pair p = wall({4, 4});
  p.truth.unshadowed.assign(p.truth.pixels(), glm::dvec3(0.25));
  for (size_t y = 0; y < 4; ++y)
    for (size_t x = 2; x < 4; ++x) {
      p.truth.diffuse[4 * y + x] = p.truth.specular[4 * y + x] = glm::dvec3(0);
      if (x == 3 || y == 0) p.drawn.lit[4 * y + x] = p.drawn.unlit[4 * y + x];
    }
  EXPECT_EQ(measured(p).shadow_wrong_pixels, 3);
  EXPECT_EQ(measured(p).shadow_edge_pixels, 0.75);
  p.truth.unshadowed.assign(p.truth.pixels(), glm::dvec3(0));
  EXPECT_EQ(measured(p).shadow_edge_pixels, 0) << "no shadow ends anywhere, and nothing is wrong";
}

TEST(BackgroundLit, CountsWhatIsBrighterThanTheBackground) {
  Pair p = wall({4, 4});
  p.truth.present[0] = p.truth.present[1] = p.truth.present[2] = 0;
  p.drawn.lit[0].b += 0.01f, p.drawn.lit[1] -= 0.2f, p.drawn.lit[2].r = kInf;
  p.drawn.lit[3] += 0.2f;  // a surface
  EXPECT_EQ(measured(p).background_lit_pixels, 2);
}

}  // namespace
}  // namespace gbl
