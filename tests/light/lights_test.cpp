#include "renderer/light/lights.h"

#include <cstring>

#include "renderer/base/random.h"
#include "renderer/frame/frame_lights.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

// FNV-1a over the bits of the doubles: any change of generator, order or formula changes it.
uint64_t hash_of(const std::vector<Light>& lights) {
  uint64_t hash = 14695981039346656037ull;
  const auto add = [&](double x) {
    uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    for (int i = 0; i < 8; ++i) hash = (hash ^ ((bits >> (8 * i)) & 255)) * 1099511628211ull;
  };
  for (const Light& l : lights) {
    for (int k = 0; k < 3; ++k) add(l.position[k]);
    for (int k = 0; k < 3; ++k) add(l.colour[k]);
    add(l.range);
  }
  return hash;
}

Scene terrain_grid() { return Scene{}; }  // its LightGrid is source 0's

TEST(Random, IsThePublishedPcg32) {
  Pcg32 random(42, 54);  // the first numbers of O'Neill's own demonstration, pcg32-demo.c
  for (const uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
    EXPECT_EQ(random.next(), expected);
}

TEST(Lights, HashOf4096IsAConstantOnEveryMachine) {
  EXPECT_EQ(hash_of(generated_lights({}, 4096, 1, 0)), 4007818494037160110ull);
  EXPECT_NE(hash_of(generated_lights({}, 4096, 2, 0)), hash_of(generated_lights({}, 4096, 1, 0)));
}

TEST(Lights, AnyNumberIsFiniteAndOnTheGrid) {
  for (const int count : {0, 1, 2, 3, 64, 65, 16384}) {
    const std::vector<Light> lights = generated_lights({}, count, 1, 12.5);
    ASSERT_EQ(static_cast<int>(lights.size()), count);
    for (const Light& l : lights) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(std::isfinite(l.position[k]));
        EXPECT_GE(l.colour[k], 0.5);
        EXPECT_LT(l.colour[k], 1.5);
      }
      EXPECT_TRUE(std::isfinite(l.range) && l.range > 0);
      // The corner of the grid stays that far from the axis, whatever the angle.
      EXPECT_LE(std::hypot(l.position.x - 2056, l.position.z - 2056), 2056 * std::sqrt(2.0) * (1 + 1e-12));
      EXPECT_EQ(l.position.y, 100);
    }
  }
}

TEST(Lights, RangeIsTheGridsExtentOverItsSide) {
  const std::pair<int, int> side_of[] = {{1, 1}, {2, 2}, {3, 2}, {4, 2}, {5, 3}, {64, 8}, {65, 9}, {16384, 128}};
  for (const auto& [count, side] : side_of)
    EXPECT_DOUBLE_EQ(generated_lights({}, count, 1, 0).front().range, 4112.0 / side) << count;
}

TEST(Lights, SixtyFourStandWhereSource0PutsThem) {
  const std::vector<Light> lights = generated_lights({}, 64, 1, 0);
  EXPECT_NEAR(4112.0 / 7, 587.43, 0.005);
  for (int i = 0; i < 64; ++i) {
    EXPECT_NEAR(lights[i].position.x, 4112.0 / 7 * (i / 8), 1e-9);  // outer loop x, inner loop z
    EXPECT_NEAR(lights[i].position.z, 4112.0 / 7 * (i % 8), 1e-9);
    EXPECT_EQ(lights[i].range, 514);
  }
}

TEST(Lights, OneStandsOnTheAxisAndTwoInOneRow) {
  const std::vector<Light> one = generated_lights({}, 1, 1, 0);
  EXPECT_EQ(one[0].position, glm::dvec3(2056, 100, 2056));
  const std::vector<Light> two = generated_lights({}, 2, 1, 0);
  EXPECT_EQ(two[0].position, glm::dvec3(0, 100, 0));
  EXPECT_EQ(two[1].position, glm::dvec3(0, 100, 4112));
}

TEST(Lights, TurnTenDegreesASecondAboutPlusYFromAbsoluteTime) {
  const std::vector<Light> start = generated_lights({}, 64, 1, 0);
  // +90 degrees about +Y take +X to -Z.
  const std::vector<Light> quarter = generated_lights({}, 64, 1, 9);
  for (int i = 0; i < 64; ++i) {
    const double x = start[i].position.x - 2056, z = start[i].position.z - 2056;
    EXPECT_NEAR(quarter[i].position.x - 2056, z, 1e-9);
    EXPECT_NEAR(quarter[i].position.z - 2056, -x, 1e-9);
    EXPECT_EQ(quarter[i].colour, start[i].colour);
  }
  const double angle = glm::radians(10.0);
  const glm::dvec3 second = generated_lights({}, 64, 1, 1)[63].position;
  EXPECT_NEAR(second.x, 2056 + 2056 * (std::cos(angle) + std::sin(angle)), 1e-9);
  for (const double turns : {1.0, 2.0, 100.0}) {  // 100 turns: an hour
    const std::vector<Light> again = generated_lights({}, 64, 1, 36 * turns);
    for (int i = 0; i < 64; ++i)
      EXPECT_LE(glm::length(again[i].position - start[i].position), 1e-9) << turns;  // no drift
  }
}

TEST(Lights, ColoursBelongToTheSeedNotToTheCount) {
  const std::vector<Light> few = generated_lights({}, 10, 7, 0), many = generated_lights({}, 1000, 7, 0);
  double lowest = 2, highest = 0, sum = 0;
  for (size_t i = 0; i < many.size(); ++i) {
    EXPECT_TRUE(i >= few.size() || few[i].colour == many[i].colour) << i;
    for (int k = 0; k < 3; ++k) {
      lowest = std::min(lowest, many[i].colour[k]);
      highest = std::max(highest, many[i].colour[k]);
      sum += many[i].colour[k];
    }
  }
  EXPECT_LT(lowest, 0.51);
  EXPECT_GT(highest, 1.49);
  EXPECT_NEAR(sum / 3000, 1, 0.03);  // five standard deviations of a mean of 3000: 5 * 0.289 / sqrt(3000)
}

TEST(Lights, InABoxFillItAndTheirColoursInEveryChannel) {
  LightBox box{.min = {-1, 2, 3}, .max = {1, 6, 11}, .rule = BoxRange::fixed, .range = 7};
  const std::vector<Light> few = generated_lights(box, 10, 3), many = generated_lights(box, 1000, 3);
  for (int k = 0; k < 3; ++k) {
    glm::dvec2 place(1e9, -1e9), colour(1e9, -1e9);
    for (const Light& l : many) {
      place = {std::min(place.x, l.position[k]), std::max(place.y, l.position[k])};
      colour = {std::min(colour.x, l.colour[k]), std::max(colour.y, l.colour[k])};
    }
    EXPECT_GE(place.x, box.min[k]);
    EXPECT_LE(place.y, box.max[k]);
    EXPECT_GT(place.y - place.x, 0.98 * (box.max[k] - box.min[k]));
    EXPECT_GE(colour.x, box.colour_min);
    EXPECT_LE(colour.y, box.colour_max);
    EXPECT_GT(colour.y - colour.x, 0.98 * (box.colour_max - box.colour_min));
  }
  for (size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].position, many[i].position) << i;
    EXPECT_EQ(few[i].colour, many[i].colour) << i;
    EXPECT_EQ(few[i].range, 7);
  }
}

TEST(LightsOf, ScaleFirstAndOnly) {
  Settings s;
  const std::vector<Light> all = lights_of(s, terrain_grid());
  ASSERT_EQ(all.size(), 64u);
  EXPECT_EQ(hash_of(all), hash_of(generated_lights({}, 64, 1, 0)));

  s.lights.range_scale = 0.5;
  for (const Light& l : lights_of(s, terrain_grid())) EXPECT_EQ(l.range, 257);
  Scene with_sun;
  with_sun.lights.resize(1);
  s.lights.source = LightSource::scene;
  EXPECT_EQ(lights_of(s, with_sun)[0].range, kEndless) << "half of endless is endless";
  s.lights.source = LightSource::generated;

  s.lights.range_scale = 1;
  const std::pair<int, size_t> firsts[] = {{-1, 64}, {0, 0}, {1, 1}, {63, 63}, {64, 64}, {1000, 64}};
  for (const auto& [first, size] : firsts) {
    s.lights.first = first;
    EXPECT_EQ(lights_of(s, terrain_grid()).size(), size) << first;
  }
  s.lights.first = -1;
  for (const int only : {0, 33, 63}) {
    s.lights.only = only;
    const std::vector<Light> one = lights_of(s, terrain_grid());
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(hash_of(one), hash_of({all[only]})) << only;
  }
  s.lights.only = 64;
  EXPECT_TRUE(lights_of(s, terrain_grid()).empty());
  s.lights.only = 10;
  s.lights.first = 10;  // the eleventh of ten
  EXPECT_TRUE(lights_of(s, terrain_grid()).empty());
}

TEST(LightsOf, TimeAndSeedAreTheSettings) {
  Settings s;
  s.time_s = 3;
  s.lights.seed = 9;
  s.lights.count = 100;
  EXPECT_EQ(hash_of(lights_of(s, terrain_grid())), hash_of(generated_lights({}, 100, 9, 3)));
}

}  // namespace
}  // namespace gbl
