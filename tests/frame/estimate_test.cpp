#include "renderer/frame/estimate.h"

#include "renderer/frame/frame_lights.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

Settings with(LightMethod method, glm::ivec2 size = {1280, 720}, int count = 64) {
  Settings s = preset("nclgl-fixed").make();
  s.lights.method = method;
  s.size = size;
  s.lights.count = count;
  return s;
}

std::vector<Light> lights(const Settings& s) { return lights_of(s, Scene{}); }
ResolvedFrame resolved(const Settings& s) { return resolve_frame(s, Scene{}, {}); }
double work(const Settings& s) { return estimate_work(s, lights(s)); }

std::vector<LightMethod> methods() {
  std::vector<LightMethod> all;
  for (const ValueRow& r : rows<LightMethod>()) all.push_back(static_cast<LightMethod>(r.value));
  return all;
}

Light light(const glm::dvec3& position, double range) {
  Light l{};
  l.position = position;
  l.colour = glm::dvec3(1);
  l.range = range;
  return l;
}

LightWork work_in(const Settings& s, const std::vector<Light>& some) {
  return work_of(s.lights.method, lights_in_view(s, some));
}

const double kPixel = llvmpipe_weights().units[Work::pixel];

TEST(EstimateWork, FullScreenIsPixelsTimesLights) {
  for (const int count : {0, 1, 64, 16384}) {
    const Settings s = with(LightMethod::fullscreen, {640, 360}, count);
    const double pairs = 640.0 * 360 * count;
    EXPECT_EQ(work_in(s, lights(s)).shaded, pairs);
    EXPECT_EQ(work_in(s, lights(s)).tested, pairs);
    EXPECT_GE(work(s), pairs);
    EXPECT_LE(work(s), pairs + (count > 0 ? kPixel * 640.0 * 360 : 0));  // and the pass itself
  }
}

TEST(EstimateWork, GrowsWithPixelsLightsAndRange) {
  for (const LightMethod m : methods()) {
    const double base = work(with(m)), four_times = work(with(m, {2560, 1440}));
    EXPECT_GT(base, 0) << row(m).id;
    EXPECT_LE(four_times, 4 * base * (1 + 1e-6)) << row(m).id;
    EXPECT_GE(four_times, 3.5 * base) << row(m).id << ": draws and lists are as many as before";
    Settings s = with(m);
    std::vector<Light> some = lights(s);
    for (double before = base; some.size() > 1; before = estimate_work(s, some)) {
      some.pop_back();
      // With a light its depths may go, and the others fill more of what is left: a seventh at most.
      EXPECT_LE(estimate_work(s, some), before * 1.15) << row(m).id;
    }
    s.lights.range_scale = 2;
    EXPECT_GE(work(s), base) << row(m).id;
    EXPECT_EQ(estimate_work(s, {}), 0) << row(m).id;
  }
}

TEST(EstimateWork, NoMethodTestsLessThanItShadesOrMoreThanAllPairs) {
  for (const double scale : {0.1, 1.0, 4.0, 1000.0})
    for (const int count : {1, 64, 4096})
      for (const LightMethod m : methods()) {
        if (m == LightMethod::auto_) continue;
        Settings s = with(m, {320, 180}, count);
        s.lights.range_scale = scale;
        const LightWork w = work_in(s, lights(s));
        EXPECT_GE(w.tested, w.shaded) << row(m).id << " " << count << " " << scale;
        EXPECT_LE(w.tested, 320.0 * 180 * count) << row(m).id << " " << count << " " << scale;
        EXPECT_GE(w.units, w.shaded * 0.1) << row(m).id;
      }
}

TEST(EstimateWork, EveryPairIsShadedWhenTheCameraIsInsideAllLights) {
  Settings s = with(LightMethod::volumes);
  const std::vector<Light> around(5, light(s.camera.position, 10));
  const double pairs = 5 * 1280.0 * 720;
  for (const LightMethod m : {LightMethod::volumes, LightMethod::quads, LightMethod::fullscreen}) {
    s.lights.method = m;
    EXPECT_EQ(work_in(s, around).shaded, pairs) << row(m).id;
  }
  s.lights.method = LightMethod::fullscreen_radius;
  EXPECT_EQ(work_in(s, around).tested, pairs);
  s.lights.method = LightMethod::volumes;
  s.lights.cull = LightCull::none;
  EXPECT_EQ(work_in(s, around).shaded, 2 * pairs);
}

TEST(EstimateWork, AVolumeCoversItsDiscAndNothingBehindTheCamera) {
  Settings s = with(LightMethod::volumes);
  s.camera = Camera{};
  s.lights.volume.fit = VolumeFit::inscribed;  // scale 1
  const double pixels = 1280.0 * 720;
  const auto shaded = [&](const Light& l) { return work_in(s, {l}).shaded; };
  // A sphere of radius 1 at 100 on the axis: pi (1/100)^2 of a picture 2 tan(22.5) high, 16:9 wide.
  const double half = std::tan(glm::radians(22.5));
  const double share = 3.14159265 * 1e-4 / (4 * half * half * 16 / 9);
  EXPECT_NEAR(shaded(light({0, 0, -100}, 1)), pixels * share, 1e-3 * pixels * share);
  EXPECT_EQ(shaded(light({0, 0, 100}, 1)), 0);
  EXPECT_EQ(shaded(light({100, 0, -100}, 1)), 0) << "beside the picture";
  EXPECT_LE(shaded(light({0, 0, -1.02}, 1)), pixels);  // never more than the whole picture
  s.lights.method = LightMethod::quads;
  EXPECT_NEAR(shaded(light({0, 0, -100}, 1)), pixels * share * 4 / 3.14159265, 1e-3 * pixels * share);
  s.camera.orthographic_height = 10;
  EXPECT_NEAR(shaded(light({0, 0, -100}, 1)), pixels * 4 / (10 * 10 * 16.0 / 9), 1e-3 * pixels);
}

TEST(FrameCost, LearnsFromFramesAndIgnoresEmptyOnes) {
  const Settings s = with(LightMethod::fullscreen);
  FrameCost cost(true);
  const double guess = cost.predict_ms(resolved(s));
  cost.learn(LightMethod::fullscreen, 1e4, 1000);  // too little work
  cost.learn(LightMethod::fullscreen, 1e9, 0);
  cost.learn(LightMethod::fullscreen, 1e9, -1);
  cost.learn(LightMethod::fullscreen, 1e9, std::nan(""));
  EXPECT_EQ(cost.predict_ms(resolved(s)), guess);
  const double pixels = 1280.0 * 720;
  for (int i = 0; i < 60; ++i) cost.learn(LightMethod::fullscreen, 1e9, 20000);  // 20 ns a pair
  EXPECT_NEAR(cost.predict_ms(resolved(s)), pixels * ((64 + kPixel) * 20 + 60) * 1e-6, 1e-6 * guess);
  EXPECT_LT(FrameCost(false).predict_ms(resolved(s)), guess);
}

TEST(FrameCost, WhatOneMethodDoesBeyondItsUnitsIsNotBlamedOnTheOthers) {
  FrameCost cost(true);
  for (int i = 0; i < 9; ++i) cost.learn(LightMethod::volumes, 1e9, 4000);
  const double before = cost.predict_ms(resolved(with(LightMethod::volumes)));
  const double of_another = cost.predict_ms(resolved(with(LightMethod::quads)));
  for (int i = 0; i < 9; ++i) cost.learn(LightMethod::forward_multipass, 1e6, 50000);  // it drew all objects 64 times
  EXPECT_EQ(cost.predict_ms(resolved(with(LightMethod::volumes))), before);
  EXPECT_EQ(cost.predict_ms(resolved(with(LightMethod::quads))), of_another) << "not drawn yet: as the quickest";
  EXPECT_GT(cost.predict_ms(resolved(with(LightMethod::forward_multipass))), 1000 * before);
}

// A machine that slept through a frame: the next pictures are so small that little can be learnt from them.
TEST(FrameCost, AFrameThatTookForeverIsForgottenThroughSmallOnes) {
  const Settings s = with(LightMethod::fullscreen);
  FrameCost cost(true);
  const double before = cost.predict_ms(resolved(s));
  cost.learn(LightMethod::fullscreen, 1e6, 3600e3);
  EXPECT_GT(cost.predict_ms(resolved(s)), 1e4 * before);
  cost.learn(LightMethod::fullscreen, 5e4, 5e4 * 3e-6);  // 3 ns a unit
  EXPECT_LT(cost.predict_ms(resolved(s)), 2 * before);
}

TEST(FrameCost, AffordableSizeFitsTheBudgetInTheSameProportions) {
  const FrameCost cost(true);
  for (const LightMethod m : methods())
    for (const glm::ivec2 size : {glm::ivec2(1280, 720), {720, 1280}, {640, 360}, {3840, 2160}, {500, 500}})
      for (const double budget_ms : {50.0, 100.0, 500.0, 2000.0, 1e9}) {
        const Settings asked = with(m, size);
        Settings s = asked;
        s.size = cost.affordable_size(resolved(asked), asked.size, budget_ms);
        const bool fitted = cost.predict_ms(resolved(asked)) <= budget_ms;
        EXPECT_EQ(s.size == asked.size, fitted) << row(m).id << " " << size.x << " " << budget_ms;
        EXPECT_TRUE(s.size.x <= size.x && s.size.y <= size.y);
        EXPECT_GE(std::min(s.size.x, s.size.y), 64);
        // Whole pixels: each side is less than one short of the exact proportion.
        EXPECT_NEAR(double(s.size.x) / size.x, double(s.size.y) / size.y, 1.0 / std::min(size.x, size.y));
        const bool at_the_floor = std::min(s.size.x, s.size.y) == 64;
        // Rounding down changes the aspect by a pixel, and the covered share with it: a hundredth.
        EXPECT_TRUE(at_the_floor || cost.predict_ms(resolved(s)) <= budget_ms * 1.01) << row(m).id << " " << size.x;
      }
}

TEST(FrameCost, TheFloorKeepsProportionsAndNeverEnlarges) {
  const FrameCost cost(true);
  const auto least = [&](glm::ivec2 size) {
    const Settings s = with(LightMethod::fullscreen, size, 16384);
    return cost.affordable_size(resolved(s), s.size, 1e-9);
  };
  EXPECT_EQ(least({1280, 720}), glm::ivec2(113, 64));
  EXPECT_EQ(least({720, 1280}), glm::ivec2(64, 113));
  EXPECT_EQ(least({1000, 1000}), glm::ivec2(64, 64));
  EXPECT_EQ(least({32, 32}), glm::ivec2(32, 32));
  EXPECT_EQ(least({16384, 1}), glm::ivec2(16384, 1));
  const Settings s = with(LightMethod::fullscreen);
  EXPECT_EQ(cost.affordable_size(resolved(s), s.size, 0), glm::ivec2(113, 64));
  EXPECT_EQ(cost.affordable_size(resolved(s), s.size, -1), glm::ivec2(113, 64));
}

}  // namespace
}  // namespace gbl
