#include "renderer/truth/flip.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "renderer/base/random.h"
#include "renderer/truth/colour_spaces.h"
#include "tests/truth/naive_flip.h"

namespace gbl {
namespace {

using namespace test;

Pixels flat(glm::ivec2 size, const glm::dvec3& coded) { return Pixels(count(size), coded); }

// A ramp, a coloured edge and noise: something for each filter.
Pixels busy(glm::ivec2 size, uint64_t seed) {
  Pcg32 random(seed);
  Pixels out;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const double ramp = 0.8 * x / size.x;
      const glm::dvec3 base = 2 * y < size.y + x % 5 ? glm::dvec3(ramp, 0.2, 0.7) : glm::dvec3(0.9, ramp, 0.1);
      out.push_back(base + 0.1 * glm::dvec3(random.unit(), random.unit(), random.unit()));
    }
  return out;
}

double mean(const std::vector<double>& map) {
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

TEST(Flip, EqualPicturesDifferNowhere) {
  const glm::ivec2 size(40, 30);
  for (const double e : flip(size, busy(size, 1), busy(size, 1))) EXPECT_EQ(e, 0);
}

TEST(Flip, FlatPicturesDifferByTheirColourAlone) {
  const glm::ivec2 size(32, 24);
  // L* is 100 and 0, a* and b* are 0: a HyAB distance of 100.
  for (const double e : flip(size, flat(size, glm::dvec3(0)), flat(size, glm::dvec3(1))))
    EXPECT_NEAR(e, by_published_colours(100), 1e-5);
  EXPECT_NEAR(by_published_colours(100), 0.967, 0.001);
  for (const double e : flip(size, flat(size, {0, 1, 0}), flat(size, {0, 0, 1})))
    EXPECT_NEAR(e, 1, 1e-9) << "the two most different colours";
}

TEST(Flip, IsTheSameAsWholeSquaresOfWeights) {
  const glm::ivec2 size(30, 23);
  const Pixels reference = busy(size, 1);
  Pixels test = busy(size, 2);
  test[40] = {1, 1, 1}, test[400] = {0, 0, 0};
  const std::vector<double> map = flip(size, reference, test);
  const Naive a(size, reference, 67), b(size, test, 67);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      ASSERT_NEAR(map[index(size, x, y)], naive_flip(a, b, {x, y}), 1e-9) << x << ", " << y;
}

TEST(Flip, DoesNotAskWhichPictureIsTheReference) {
  const glm::ivec2 size(40, 30);
  EXPECT_EQ(flip(size, busy(size, 1), busy(size, 2)), flip(size, busy(size, 2), busy(size, 1)));
}

TEST(Flip, TurnsWithThePicture) {
  const glm::ivec2 size(40, 30);
  const auto turned = [&](const auto& picture) {
    auto out = picture;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) out[index({size.y, size.x}, y, x)] = picture[index(size, x, y)];
    return out;
  };
  const Pixels a = busy(size, 1), b = busy(size, 2);
  const std::vector<double> expected = turned(flip(size, a, b)), got = flip({30, 40}, turned(a), turned(b));
  for (size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(got[i], expected[i], 1e-9);
}

TEST(Flip, OnePixelSpreadsAsFarAsItsFilterAndNoFurther) {
  const glm::ivec2 size(64, 48), at(30, 20);
  const Pixels grey = flat(size, glm::dvec3(0.5));
  Pixels spot = grey;
  spot[index(size, at.x, at.y)] = glm::dvec3(0.9);
  const std::vector<double> map = flip(size, grey, spot);
  const int reach = 10;  // ceil(3 x 0.045 degrees x 67 pixels per degree), the colour filter's
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const double e = map[index(size, x, y)];
      const int distance = std::max(std::abs(x - at.x), std::abs(y - at.y));
      EXPECT_TRUE(distance <= reach || e == 0) << x << ", " << y;
      EXPECT_TRUE(distance > 2 || e > 0) << x << ", " << y;
    }
  EXPECT_GT(mean(map), 0);
  EXPECT_LT(mean(map), 0.01);
}

TEST(Flip, GrowsWithContrast) {
  const glm::ivec2 size(32, 24);
  double before = 0;
  for (const double step : {1 / 255.0, 0.01, 0.03, 0.1, 0.2, 0.4}) {
    Pixels test = flat(size, glm::dvec3(0.4));
    for (size_t i = 0; i < test.size(); ++i) test[i] += (i / 4) % 2 ? step : 0.0;
    const double now = mean(flip(size, flat(size, glm::dvec3(0.4)), test));
    EXPECT_GT(now, before) << step;
    before = now;
  }
}

TEST(Flip, FinePatternsFadeWithDistance) {
  const glm::ivec2 size(48, 48);
  Pixels checks;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) checks.emplace_back((x + y) % 2 ? 0.8 : 0.2);
  const glm::dvec3 between = 0.5 * (linear_from_srgb(glm::dvec3(0.8)) + linear_from_srgb(glm::dvec3(0.2)));
  const Pixels grey = flat(size, srgb_from_linear(between));
  EXPECT_LT(mean(flip(size, grey, checks, 67)), 0.5 * mean(flip(size, grey, checks, 15)));
}

TEST(Flip, StaysWithinItsRange) {
  const glm::ivec2 size(40, 30);
  Pcg32 random(5);
  Pixels a, b;
  for (size_t i = 0; i < count(size); ++i) {
    a.emplace_back(random.next() % 2, random.next() % 2, random.next() % 2);
    b.emplace_back(random.next() % 2, random.next() % 2, random.next() % 2);
  }
  for (const double ppd : {1.0, 8.0, 67.0, 200.0})
    for (const double e : flip(size, a, b, ppd)) EXPECT_TRUE(e >= 0 && e <= 1) << e << " at " << ppd;
}

TEST(Flip, TakesPicturesSmallerThanItsFilters) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 7), glm::ivec2(9, 1), glm::ivec2(2, 2)})
    for (const double e : flip(size, flat(size, glm::dvec3(0)), flat(size, glm::dvec3(1))))
      EXPECT_NEAR(e, by_published_colours(100), 1e-5);
  EXPECT_TRUE(flip({0, 0}, {}, {}).empty());
}

}  // namespace
}  // namespace gbl
