// Times of passes: the only tests about time, so they run alone and take the best of five.
#include <chrono>

#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Timers : public GlTest {};

// Some 50 ms on a software driver with two cores, nearly all of it in the lighting pass.
Settings heavy() {
  Settings s = settings_for(yard(), {320, 180});
  s.lights.method = LightMethod::fullscreen;
  s.lights.count = 256;
  return s;
}

double sum_ms(const FrameReport& report) {
  double sum = 0;
  for (const PassTime& p : report.passes) sum += p.ms.value_or(0);
  return sum;
}

struct Timed {
  double wall_ms = 0;  // from an idle GPU to an idle GPU
  FrameReport report;
};

Timed timed_frame(Stage& stage, const Settings& s) {
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  Timed t;
  t.report = stage.draw(s);
  glFinish();
  t.wall_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  stage.renderer.collect(stage.targets, t.report, true);
  return t;
}

void expect_sum_of_passes_is_the_frame(Stage& stage) {
  Settings s = heavy();
  timed_frame(stage, s);
  while (timed_frame(stage, s).wall_ms < 20 && s.lights.count < kMaxLights) s.lights.count *= 2;  // a fast machine
  double best = 0;  // the ratio that is nearest to 1
  for (int k = 0; k < 5; ++k) {
    const Timed t = timed_frame(stage, s);
    ASSERT_EQ(t.report.passes.size(), 3u);
    for (const PassTime& p : t.report.passes) ASSERT_TRUE(p.ms) << p.pass;
    EXPECT_GT(*t.report.passes[1].ms, 5) << "the heavy pass never takes no time";
    const double ratio = sum_ms(t.report) / t.wall_ms;
    if (std::abs(ratio - 1) < std::abs(best - 1)) best = ratio;
  }
  // Passes may overlap a little, and some time belongs to none: uploads, and the wait at the end.
  EXPECT_GT(best, 0.5);
  EXPECT_LT(best, 1.2);
}

TEST_F(Timers, PassesSumUpToTheFrame) {
  if (!gl::device().features.has(Feature::timer_query)) GTEST_SKIP() << "this driver has no timer queries";
  Stage stage(yard());
  expect_sum_of_passes_is_the_frame(stage);
}

TEST_F(Timers, WithoutQueriesTheCpuClockIsUsedAndSaid) {
  FeatureSet without;
  without.add(Feature::timer_query);
  gl::probe_device(without);
  Stage stage(yard());
  EXPECT_EQ(stage.draw(heavy()).time_source, "cpu-clock");
  expect_sum_of_passes_is_the_frame(stage);
}

TEST_F(Timers, TheSourceIsNamed) {
  Stage stage(yard());
  const std::string source = stage.draw(settings_for(yard(), {8, 4})).time_source;
  if (gl::device().software)
    EXPECT_EQ(source, "software-rasteriser");
  else
    EXPECT_EQ(source, "gpu-query");
}

// In the order drawn, several views in a row as one.
TEST_F(Timers, PassesAreNamedInTheOrderDrawn) {
  Stage stage(yard());
  const Settings s = settings_for(yard(), {64, 36});
  FrameReport report = stage.draw(s);
  stage.renderer.count_pairs(s, yard(), stage.targets, true);
  stage.renderer.draw_view(View::final, s, yard(), stage.targets);
  stage.renderer.collect(stage.targets, report, true);
  std::vector<std::string> names;
  for (const PassTime& p : report.passes) names.push_back(p.pass);
  ASSERT_GE(names.size(), 5u);
  names.resize(4);
  EXPECT_EQ(names, (std::vector<std::string>{"geometry", "lighting", "combine", "count"}));
}

// A query that was never answered says nothing, and one of an earlier frame is not the newest once a later has answered.
TEST_F(Timers, ManyFramesUnderWayAnswerInOrder) {
  Stage stage(yard());
  Settings s = heavy();
  timed_frame(stage, s);
  const Timed slow = timed_frame(stage, s);
  s.size = {32, 18};
  FrameReport report;
  for (int k = 0; k < 9; ++k) report = stage.draw(s);  // more than are kept
  stage.renderer.collect(stage.targets, report, true);
  EXPECT_LT(*report.passes[1].ms, *slow.report.passes[1].ms / 5) << "a hundredth of the pixels";
}

}  // namespace
}  // namespace gbl::test
