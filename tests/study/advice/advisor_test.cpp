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
  bool nothing_holds = false;

  BoundCheck check(const Settings& s, int camera) {
    ++judged;
    BoundCheck b;
    b.compared = 1000;
    const bool together =
        s.normal.encoding == NormalEncoding::oct12 && s.accumulation.format == AccumulationFormat::rgba16f;
    const bool bad = s.normal.encoding == NormalEncoding::oct8 || s.depth.format == DepthFormat::d16 || together ||
                     s.accumulation.format == AccumulationFormat::rgba8 || nothing_holds;
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
  EXPECT_EQ(failing, 4u) << "oct8, d16 and rgba8 with one or two targets";
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
  error_line(ExitCode::interrupted, [&] { w.advise(AdviceCost::pairs); });
  EXPECT_EQ(w.judged, 0);
}

TEST(ErrorBudget, IsAShareOrEveryPixel) {
  BoundCheck b;
  b.compared = 1000, b.over = 1;
  EXPECT_TRUE((ErrorBudget{1 / 255.0, 0.001}.holds(b)));
  EXPECT_FALSE((ErrorBudget{1 / 255.0, 0}.holds(b)));
}

}  // namespace
}  // namespace gbl::test
