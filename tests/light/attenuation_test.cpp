#include "renderer/light/attenuation.h"

#include <gtest/gtest.h>

#include "renderer/frame/frame_lights.h"
#include "renderer/light/lights.h"

namespace gbl {
namespace {

constexpr Attenuation kAll[] = {Attenuation::none, Attenuation::linear,         Attenuation::quadratic,
                                Attenuation::ramp, Attenuation::inverse_linear, Attenuation::windowed,
                                Attenuation::gltf};

TEST(Attenuation, IsTheFormulaOfItsSource) {
  EXPECT_EQ(attenuation_at(Attenuation::none, 7, 4), 1);
  EXPECT_DOUBLE_EQ(attenuation_at(Attenuation::linear, 1, 4), 0.75);
  EXPECT_EQ(attenuation_at(Attenuation::linear, 4, 4), 0);
  EXPECT_DOUBLE_EQ(attenuation_at(Attenuation::quadratic, 2, 4), 1 / (1 + 0.7 * 2 + 1.8 * 4));
  EXPECT_EQ(attenuation_at(Attenuation::ramp, 0.5, 4), 1);  // full up to a quarter of the range
  EXPECT_DOUBLE_EQ(attenuation_at(Attenuation::ramp, 4, 4), 1 / (0.2 + 1.6 + 6.4));
  EXPECT_DOUBLE_EQ(attenuation_at(Attenuation::inverse_linear, 4, 4), 0.1);
  EXPECT_DOUBLE_EQ(attenuation_at(Attenuation::windowed, 2, 4), (1 - 0.0625) * (1 - 0.0625) / 4);
  EXPECT_EQ(attenuation_at(Attenuation::windowed, 4, 4), 0);
}

TEST(Attenuation, NeverRisesWithDistance) {
  for (const Attenuation a : kAll) {
    double last = attenuation_at(a, 0, 5);
    for (int k = 1; k < 1000; ++k) {
      const double d = 0.01 * k, now = attenuation_at(a, d, 5);
      EXPECT_LE(now, last) << row(a).id << " at " << d;
      last = now;
    }
  }
}

TEST(RangeAtThreshold, IsWhereTheProfileCrosses) {
  for (const Attenuation a : kAll) {
    if (a == Attenuation::none) continue;
    for (const double strength : {0.5, 1.0, 8.0}) {
      const double r = range_at_threshold(a, strength, 6, 5.0 / 256);
      EXPECT_NEAR(strength * attenuation_at(a, r, 6), 5.0 / 256, 1e-9) << row(a).id << " " << strength;
    }
  }
  EXPECT_EQ(range_at_threshold(Attenuation::none, 1, 6, 5.0 / 256), 6);  // it never gets there: its own range
}

// Source 2's own formula; 3.5 to 5.1 units for its colours.
TEST(RangeAtThreshold, IsLearnOpenGLsRadius) {
  for (const double brightest : {0.5, 0.7, 1.0}) {
    const double c = 1 - 256.0 / 5 * brightest;
    EXPECT_NEAR(range_at_threshold(Attenuation::quadratic, brightest, 99, 5.0 / 256),
                (-0.7 + std::sqrt(0.49 - 7.2 * c)) / 3.6, 1e-9);
  }
}

// `radius-nan-dim-light`: too dim to reach the threshold anywhere is no light, not a NaN.
TEST(RangeAtThreshold, OfALightThatIsTooDimIsNothing) {
  for (const Attenuation a : {Attenuation::none, Attenuation::linear, Attenuation::quadratic, Attenuation::ramp})
    EXPECT_EQ(range_at_threshold(a, 0.018, 5, 5.0 / 256), 0) << row(a).id;
  EXPECT_EQ(range_at_threshold(Attenuation::linear, 1, 0, 5.0 / 256), 0);
}

// `range-shortcut`: 64 to 73 % of the true range once the light is five times as bright as the threshold.
TEST(RangeByShortcut, UnderestimatesTheRange) {
  for (const double strength : {0.1, 0.5, 1.0, 2.0}) {
    const double ratio =
        range_by_shortcut(strength, 4, 5.0 / 256) / range_at_threshold(Attenuation::ramp, strength, 4, 5.0 / 256);
    EXPECT_GT(ratio, 0.63) << strength;
    EXPECT_LT(ratio, 0.95) << strength;
  }
  EXPECT_NEAR(range_by_shortcut(100 * 5.0 / 256, 4, 5.0 / 256), 9.99, 0.005);  // radius 1, A = 100
}

Settings with_one_light(RangeKind kind) {
  Settings s;
  s.lights.count = 1;
  s.range.kind = kind;
  s.attenuation = Attenuation::quadratic;
  return s;
}

TEST(LightsOf, EndAsTheRangeKindSaysAndKeepTheirProfile) {
  const Scene scene;
  const double own = lights_of(with_one_light(RangeKind::source), scene)[0].range;
  for (const RangeKind kind : {RangeKind::source, RangeKind::threshold, RangeKind::windowed, RangeKind::none})
    EXPECT_EQ(lights_of(with_one_light(kind), scene)[0].profile_range, own) << row(kind).id;
  EXPECT_LT(lights_of(with_one_light(RangeKind::threshold), scene)[0].range, 20);  // of 4112
  EXPECT_EQ(lights_of(with_one_light(RangeKind::none), scene)[0].range, kEndless);
  EXPECT_EQ(lights_of(with_one_light(RangeKind::windowed), scene)[0].range, own);
}

// Where the radiance on white, after exposure, is 1/255 of what the display shows: by the light's own falloff.
TEST(LightsOf, WithoutAStatedRangeTheyEndWhereTheyAreFaint) {
  Scene scene;
  scene.lights.resize(1);
  Light& l = scene.lights[0];
  l.colour = {40, 20, 0}, l.ends_faint = true;
  Settings s;
  s.lights.source = LightSource::scene;
  for (const double exposure : {1e-4, 1.0, 30.0})
    for (const Attenuation attenuation : {Attenuation::windowed, Attenuation::gltf})
      for (const glm::dvec3 falloff :
           {glm::dvec3(0), glm::dvec3(1, 0, 0.5), glm::dvec3(1, 2, 0), glm::dvec3(0, 0, 3)}) {
        s.exposure = exposure, s.attenuation = attenuation, l.coefficients = falloff;
        const Light lit = lights_of(s, scene)[0];
        const glm::dvec3 k = falloff == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : falloff;
        const double left = 40 * exposure / (k.x + lit.range * (k.y + lit.range * k.z));
        if (40 * exposure * 255 > k.x)
          EXPECT_NEAR(left * 255, 1, 1e-9);
        else
          EXPECT_EQ(lit.range, 0) << "it is faint everywhere";
      }
  l.coefficients = {1, 0, 0}, s.exposure = 1;
  EXPECT_EQ(lights_of(s, scene)[0].range, kEndless) << "without falloff it gets faint nowhere";
  l.coefficients = glm::dvec3(0), s.attenuation = Attenuation::gltf;
  EXPECT_EQ(lights_of(s, scene)[0].profile_range, kEndless) << "no window takes light away before the end";
  s.lights.range_scale = 0.5;
  EXPECT_NEAR(lights_of(s, scene)[0].range, std::sqrt(255 * 40) / 2, 1e-9);
  l.range = 3, l.ends_faint = false;
  EXPECT_EQ(lights_of(s, scene)[0].range, 1.5) << "a stated range stays";
}

TEST(LightsOf, WithoutAnEdgeKeepsATwentiethAtTheOuterAngle) {
  Scene scene;
  Light spot;
  spot.kind = LightKind::spot;
  spot.inner_cos = 0.95, spot.outer_cos = 0.8;
  scene.lights = {spot};
  Settings s;
  s.lights.source = LightSource::scene;
  s.lights.spot = LightSpot::cos_power;
  const Light open = lights_of(s, scene)[0];
  EXPECT_EQ(open.outer_cos, -1);
  EXPECT_NEAR(std::pow(0.8, open.inner_cos), 0.05, 1e-12);
}

TEST(LightsOf, RefusesNumbersThatAreNotFinite) {
  Scene scene;
  scene.lights.resize(3);
  scene.lights[1].colour.y = NAN;
  Settings s;
  s.lights.source = LightSource::scene;
  EXPECT_THROW(lights_of(s, scene), std::runtime_error);
}

}  // namespace
}  // namespace gbl
