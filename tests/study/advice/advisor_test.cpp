// The advisor's logic with made-up measurements: what is tried, what is chosen, what is said.
#include "renderer/study/advice/advisor.h"

#include <gtest/gtest.h>

#include "renderer/frame/attachments.h"
#include "renderer/frame/resolve.h"
#include "tests/test_support.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

FeatureSet all_features() {
  FeatureSet f;
  for (const FeatureRow& r : kFeatures) f.add(r.feature);
  return f;
}

// A world in which these alone fail: 8-bit normals, D16, and RGBA8 sums; and 12-bit normals together with half floats.
struct World {
  Scene scene = make_plane(5);
  Settings truth;
  ErrorBudget budget;
  int judged = 0, measured = 0;
  std::atomic<bool> cancel{false};
  bool nothing_holds = false, forward_holds = true, prepass_holds = true;
  NormalEncoding also_bad = NormalEncoding::oct8;
  int stop_after = 1 << 30;

  BoundCheck check(const Settings& s, int camera) {
    if (++judged == stop_after) cancel = true;
    BoundCheck b;
    b.compared = 1000;
    const bool together =
        s.normal.encoding == NormalEncoding::oct12 && s.accumulation.format == AccumulationFormat::rgba16f;
    const bool bad = s.normal.encoding == NormalEncoding::oct8 || s.depth.format == DepthFormat::d16 || together ||
                     s.accumulation.format == AccumulationFormat::rgba8 || nothing_holds ||
                     s.normal.encoding == also_bad ||
                     (!forward_holds && shading_of(s.lights.method) == Shading::forward) ||
                     (!prepass_holds && shading_of(s.lights.method) == Shading::light_prepass);
    if (bad && camera == 3) b.over = 20, b.worst = 9 / 255.0;
    return b;
  }

  Advice advise(AdviceCost cost, double cheapest_method = 0) {
    return gbl::advise(
        truth, scene, budget, cost, {all_features()}, [&](const Settings& s, int camera) { return check(s, camera); },
        [&](const Settings& s) {
          ++measured;
          return s.lights.method == static_cast<LightMethod>(cheapest_method) ? 1.0 : 2.0 + int(s.lights.method);
        },
        [](const std::string&) {}, cancel);
  }
};

TEST(Advisor, FewestBytesThatHold) {
  World w;
  const Advice advice = w.advise(AdviceCost::bytes);
  ASSERT_TRUE(advice.best && advice.runner_up);
  const Settings& s = advice.best->settings;
  EXPECT_TRUE(sound(s));
  EXPECT_NE(s.lights.method, LightMethod::auto_) << "explicit values";
  EXPECT_EQ(advice.best->bytes_per_pixel,
            gbuffer_bytes_per_pixel(resolve(s, w.scene).settings) + accumulation_bytes_per_pixel(s));
  for (int camera = 0; camera < kAdviceCameras; ++camera) EXPECT_EQ(w.check(s, camera).over, 0u);
  EXPECT_LE(advice.best->cost, advice.runner_up->cost);
  EXPECT_TRUE(setup_values(s) != setup_values(advice.runner_up->settings));
  EXPECT_EQ(w.measured, 0) << "bytes are known";
}

TEST(Advisor, SaysWhatFailsAndWhere) {
  World w;
  const Advice advice = w.advise(AdviceCost::bytes);
  const auto said = [&](std::string_view what) {
    for (const std::string& l : advice.left_out)
      if (contains(l, what) && contains(l, "camera 3") && contains(l, "2 %") && contains(l, "9 codes")) return true;
    return false;
  };
  EXPECT_TRUE(said("normal.encoding=oct8:"));
  EXPECT_TRUE(said("depth.format=d16:"));
  EXPECT_TRUE(said("accumulation.format=rgba8"));
  EXPECT_FALSE(said("normal.encoding=oct16:"));
  size_t failing = 0;
  for (const Tried& t : advice.values) failing += !t.holds;
  EXPECT_EQ(failing, 5u) << "oct8, d16 and rgba8, whatever the targets";
  for (const Tried& t : advice.values)
    for (const ValueRow& r : rows<NormalEncoding>())
      EXPECT_TRUE(r.sound() || t.values != (std::vector<Assignment>{{"normal.encoding", r.id}}))
          << "unsound values are not advised";
}

TEST(Advisor, TakesTheMethodThatMeasuresCheapest) {
  World w;
  for (const LightMethod m : {LightMethod::clustered, LightMethod::quads}) {
    const Advice advice = w.advise(AdviceCost::time, double(m));
    ASSERT_TRUE(advice.best);
    EXPECT_EQ(advice.best->settings.lights.method, m);
    EXPECT_EQ(advice.best->cost, 1);
    EXPECT_GE(advice.runner_up->cost, advice.best->cost);
  }
}

TEST(Advisor, NothingIsAdvisedWhereNothingHolds) {
  World w;
  w.nothing_holds = true;
  const Advice advice = w.advise(AdviceCost::bytes);
  EXPECT_FALSE(advice.best || advice.runner_up);
  EXPECT_FALSE(advice.values.empty());
}

TEST(Advisor, CanBeStopped) {
  World w;
  w.cancel = true;
  const Advice nothing = w.advise(AdviceCost::pairs);
  EXPECT_TRUE(nothing.stopped);
  EXPECT_FALSE(nothing.best);
  EXPECT_EQ(w.judged, 0);
}

TEST(Advisor, StoppedOnTheWayItGivesTheCheapestSoFarThatHolds) {
  World w;
  w.stop_after = 60;
  const Advice some = w.advise(AdviceCost::bytes);
  EXPECT_TRUE(some.stopped);
  ASSERT_TRUE(some.best);
  for (int camera = 0; camera < kAdviceCameras; ++camera) EXPECT_EQ(w.check(some.best->settings, camera).over, 0u);
  EXPECT_FALSE(World().advise(AdviceCost::bytes).stopped);
}

// All sound combinations, one by one: what the ordered search must find.
int fewest_bytes_by_brute_force(World& w) {
  int fewest = 1 << 20;
  for (const LightMethod method : {LightMethod::fullscreen, LightMethod::prepass, LightMethod::forward})
    for (const ValueRow& layout : rows<Layout>())
      for (const ValueRow& normal : rows<NormalEncoding>())
        for (const DepthFormat depth : {DepthFormat::d16, DepthFormat::d32f_reversed})
          for (const ValueRow& format : rows<AccumulationFormat>())
            for (const AccumulationTargets targets : {AccumulationTargets::split, AccumulationTargets::one}) {
              Settings s = w.truth;
              s.lights.cull = LightCull::front;
              s.lights.method = method;
              s.layout = static_cast<Layout>(layout.value),
              s.normal.encoding = static_cast<NormalEncoding>(normal.value);
              s.depth.format = depth;
              s.accumulation = {static_cast<AccumulationFormat>(format.value), targets};
              if (s.layout == Layout::auto_ || succeeds_another(s.layout) || !sound(s)) continue;
              if (!validate(s, {all_features()}).empty()) continue;
              bool holds = true;
              for (int camera = 0; camera < kAdviceCameras && holds; ++camera)
                holds = w.budget.holds(w.check(s, camera));
              const Settings r = resolve(s, w.scene).settings;
              if (holds) fewest = std::min(fewest, gbuffer_bytes_per_pixel(r) + accumulation_bytes_per_pixel(r));
            }
  return fewest;
}

TEST(Advisor, BytesAreTheFewestOfAllCombinations) {
  for (const bool forward : {true, false})
    for (const bool prepass : {true, false})
      for (const NormalEncoding worst : {NormalEncoding::oct8, NormalEncoding::oct14}) {
        World w;
        w.forward_holds = forward, w.prepass_holds = prepass, w.also_bad = worst;
        const int expected = fewest_bytes_by_brute_force(w);
        const Advice advice = w.advise(AdviceCost::bytes);
        ASSERT_TRUE(advice.best);
        EXPECT_EQ(advice.best->bytes_per_pixel, expected)
            << forward << prepass << in_words(setup_values(advice.best->settings));
        EXPECT_EQ(forward, advice.best->settings.lights.method == LightMethod::forward);
      }
}

// Pairs are the method's alone: the fewest of all that hold, then fewest bytes.
TEST(Advisor, PairsAreThoseOfTheMethodWithTheFewest) {
  for (const LightMethod m : {LightMethod::clustered, LightMethod::forward, LightMethod::prepass}) {
    World w;
    const Advice advice = w.advise(AdviceCost::pairs, double(m));
    ASSERT_TRUE(advice.best);
    EXPECT_EQ(advice.best->settings.lights.method, m);
    EXPECT_EQ(advice.best->cost, 1);
  }
}

TEST(Advisor, ByTimeItShowsAllThatItIsTheFastestOf) {
  World w;
  const Advice advice = w.advise(AdviceCost::time, double(LightMethod::quads));
  EXPECT_EQ(int(advice.measured.size()), w.measured);
  EXPECT_GT(advice.measured.size(), 6u);
  for (const AdvisedSetup& m : advice.measured) EXPECT_GE(m.cost, advice.best->cost);
}

TEST(ErrorBudget, IsAShareOrEveryPixel) {
  BoundCheck b;
  b.compared = 1000, b.over = 1;
  EXPECT_TRUE((ErrorBudget{1 / 255.0, 0.001}.holds(b)));
  EXPECT_FALSE((ErrorBudget{1 / 255.0, 0}.holds(b)));
}

// Shadows: the share over halves with each larger map up to 2048 and stays then; the second of three lights is enough.
struct ShadowWorld : World {
  double floor = 0.0;
  ShadowWorld() {
    truth.shadows = Shadows::all;
    truth.lights.source = LightSource::scene;
    scene.lights = {point_light({0, 1, 0}), point_light({1, 1, 0}), point_light({2, 1, 0})};
    for (Light& l : scene.lights) l.kind = LightKind::spot;  // one map each
  }
  Advice advise_with_shadows() {
    return gbl::advise(
        truth, scene, budget, AdviceCost::bytes, {all_features()},
        [&](const Settings& s, int camera) {
          BoundCheck b = check(s, camera);
          b.compared *= 100, b.over *= 100;
          if (s.shadows == Shadows::off) return b;
          const int size = std::min(static_cast<int>(s.shadow.map_size), static_cast<int>(ShadowMapSize::s2048));
          b.over += static_cast<size_t>(800 >> size) + static_cast<size_t>(floor * 100000);  // 0.8 % … 0.1 %
          if (s.shadow.max_lights < 2) b.over += 5000;
          return b;
        },
        [](const Settings&) { return 1.0; }, [](const std::string&) {}, cancel);
  }
};

TEST(Advisor, ShadowsAreAskedForApartFromWhatIsStored) {
  ShadowWorld w;
  World without;
  const Advice a = w.advise_with_shadows(), plain = without.advise(AdviceCost::bytes);
  ASSERT_TRUE(a.best && a.runner_up && plain.best);
  EXPECT_EQ(a.best->bytes_per_pixel, plain.best->bytes_per_pixel) << "a shadow's edge must not ask for more bits";
  ASSERT_EQ(a.sights.size(), 2u);
  for (const AdvisedSetup& s : {*a.best, *a.runner_up}) {
    EXPECT_EQ(s.settings.shadows, Shadows::all);
    EXPECT_EQ(s.settings.shadow.map_size, ShadowMapSize::s2048) << "the first that holds 0.1 %";
    EXPECT_EQ(s.settings.shadow.max_lights, 2) << "the third light's shadow changes nothing";
  }
  ASSERT_TRUE(a.best->together);
  EXPECT_TRUE(a.best->together->holds);
  EXPECT_TRUE(contains(in_words(setup_values(a.best->settings)), "shadow.map-size=2048 shadow.max-lights=2"));
}

// All maps share one texture: of 18 maps those of 2048 texels leave two out, and are no answer.
TEST(Advisor, MapsWithoutRoomForAllLightsAreNotTried) {
  ShadowWorld w;
  for (Light& l : w.scene.lights) l.kind = LightKind::point;  // six maps each
  const Advice a = w.advise_with_shadows();
  ASSERT_TRUE(a.best);
  ASSERT_EQ(a.sights.size(), 2u);
  EXPECT_EQ(a.sights[0].tried.size(), 3u) << "256, 512, 1024";
  EXPECT_EQ(a.best->settings.shadow.map_size, ShadowMapSize::s1024);
}

// Where no map holds the budget: the smallest that is as good as the largest within it.
TEST(Advisor, TakesTheSmallestMapThatIsAsGoodAsTheBest) {
  ShadowWorld w;
  w.floor = 0.02;
  const Advice a = w.advise_with_shadows();
  ASSERT_TRUE(a.best && a.best->together);
  EXPECT_EQ(a.best->settings.shadow.map_size, ShadowMapSize::s1024) << "2.2 %, and 2.1 % is the least";
  EXPECT_FALSE(a.best->together->holds);
  bool said = false;
  for (const std::string& line : a.left_out) said |= contains(line, "no more of shadow maps brings that down");
  EXPECT_TRUE(said);
}

TEST(Advisor, WithoutShadowsNothingIsAskedOfThem) {
  World w;
  const Advice a = w.advise(AdviceCost::bytes);
  EXPECT_TRUE(a.sights.empty());
  EXPECT_FALSE(a.best->together);
}

}  // namespace
}  // namespace gbl::test
