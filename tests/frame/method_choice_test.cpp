// lights.method=auto: which method in which situation, always a sound one that the device has.
#include "renderer/frame/method_choice.h"

#include "renderer/frame/attachments.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

FeatureSet everything() {
  FeatureSet all;
  for (const FeatureRow& f : kFeatures) all.add(f.feature);
  return all;
}

Settings automatic(int count, double range_scale = 1) {
  Settings s = preset("nclgl-fixed").make();
  s.lights.method = LightMethod::auto_;
  s.size = {640, 360};
  s.lights.count = count;
  s.lights.range_scale = range_scale;
  return s;
}

MethodChoice choice(const Settings& s, FeatureSet features = {}) {
  return choose_method(s, lights_of(s, Scene{}), features);
}

struct Situation {
  const char* name;
  Settings settings;
  LightMethod expected;  // on the core path
};

std::vector<Situation> situations() {
  return {{"no light", automatic(0), LightMethod::fullscreen},
          {"one light that reaches all", automatic(1, 1000), LightMethod::quads},
          {"64 lights that reach all", automatic(64, 1000), LightMethod::fullscreen},
          {"16384 lights that reach all", automatic(16384, 1000), LightMethod::fullscreen},
          {"64 lights, local", automatic(64), LightMethod::clustered},
          {"1024 lights, local", automatic(1024), LightMethod::clustered},
          {"16384 lights, local", automatic(16384), LightMethod::clustered},
          {"4 tiny lights", automatic(4, 0.05), LightMethod::quads}};
}

TEST(MethodChoice, NamedSituations) {
  for (const Situation& at : situations()) {
    const MethodChoice c = choice(at.settings);
    EXPECT_STREQ(row(c.method).id, row(at.expected).id) << at.name << ": " << c.reason;
    EXPECT_GT(c.reason.size(), 10u) << at.name;
  }
}

// One full-screen pass or one rectangle: 4.4 and 3.7 ms where this was measured.
TEST(MethodChoice, ASunAloneIsOneDraw) {
  Light sun;
  sun.kind = LightKind::directional;
  EXPECT_EQ(choose_method(automatic(1), {sun}, everything()).method, LightMethod::quads);
  EXPECT_EQ(choose_method(automatic(1), {sun, sun, sun}, everything()).method, LightMethod::fullscreen);
}

TEST(MethodChoice, AGuessIsCalledOne) {
  EXPECT_EQ(choice(automatic(64)).reason.find("guess"), std::string::npos);
  WorkWeights of_another_device = llvmpipe_weights();
  of_another_device.guessed = true;
  use_work_weights(of_another_device);
  const std::string reason = choice(automatic(64)).reason;
  use_work_weights(llvmpipe_weights());
  EXPECT_NE(reason.find("bench --calibrate"), std::string::npos) << reason;
}

TEST(MethodChoice, FollowsTheWeightsOfTheDevice) {
  WorkWeights blends_for_nothing = llvmpipe_weights();
  blends_for_nothing.units[Work::fragment] = blends_for_nothing.units[Work::quad] = 0.01;
  use_work_weights(blends_for_nothing);
  const LightMethod chosen = choice(automatic(1024)).method;
  use_work_weights(llvmpipe_weights());
  EXPECT_EQ(chosen, LightMethod::quads);
  EXPECT_EQ(choice(automatic(1024)).method, LightMethod::clustered);
}

TEST(MethodChoice, WhatIsAskedForByNameIsDrawnAndNeedsNoReason) {
  for (const ValueRow& r : rows<LightMethod>()) {
    Settings s = automatic(64);
    s.lights.method = static_cast<LightMethod>(r.value);
    if (s.lights.method == LightMethod::auto_) continue;
    EXPECT_EQ(choice(s).method, s.lights.method) << r.id;
    EXPECT_EQ(choice(s).reason, "") << r.id;
  }
}

// Of all sound and available methods none is estimated to be cheaper.
TEST(MethodChoice, IsSoundAvailableAndTheCheapest) {
  for (const FeatureSet features : {FeatureSet(), everything()})
    for (const LightCull cull : {LightCull::flip_safe, LightCull::back})
      for (const double scale : {0.02, 0.2, 1.0, 3.0, 30.0})
        for (const int count : {1, 2, 5, 16, 64, 1024, 16384}) {
          Settings s = automatic(count, scale);
          s.lights.cull = cull;
          const std::vector<Light> lights = lights_of(s, Scene{});
          const LightMethod chosen = choose_method(s, lights, features).method;
          Settings drawn = s;
          drawn.lights.method = chosen;
          EXPECT_NE(chosen, LightMethod::auto_);
          EXPECT_TRUE(sound(drawn)) << row(chosen).id;
          EXPECT_TRUE(features.has(row(chosen).needs)) << row(chosen).id;
          const LightsInView view = lights_in_view(s, lights);
          for (const ValueRow& r : rows<LightMethod>()) {
            const auto other = static_cast<LightMethod>(r.value);
            Settings named = s;
            named.lights.method = other;
            if (other == LightMethod::auto_ || !features.has(r.needs) || !sound(named)) continue;
            if (attachments(named).size() != attachments(s).size()) continue;  // what is stored must not change
            EXPECT_LE(work_of(chosen, view).units, work_of(other, view).units)
                << row(chosen).id << " before " << r.id << ", " << count << " lights, range x " << scale;
          }
        }
}

TEST(MethodChoice, AutoIsPredictedAsItsChoiceOnTheCorePath) {
  for (const Situation& at : situations()) {
    Settings s = at.settings;
    const std::vector<Light> lights = lights_of(s, Scene{});
    const double automatic_work = estimate_work(s, lights);
    s.lights.method = at.expected;
    EXPECT_EQ(automatic_work, estimate_work(s, lights)) << at.name;
  }
}

}  // namespace
}  // namespace gbl
