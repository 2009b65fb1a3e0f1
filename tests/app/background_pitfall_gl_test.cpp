// The numbers of an open pitfall arrive while the window goes on, and are those of the command.
#include "app/background_pitfall.h"

#include <thread>

#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class PitfallJob : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
    job_ = std::make_unique<BackgroundPitfall>(*lab_);
  }
  const ui::PitfallInput& run(const std::string& id) {
    ui::Requests r;
    r.pitfall.id = id;
    for (int i = 0; i < 600000; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the reference is made on threads of its own
      job_->update(preset("start").make(), r, true);
      if (!job_->busy()) break;
    }
    job_->fill(input_);
    return *input_.pitfall;
  }
  std::unique_ptr<Lab> lab_;
  std::unique_ptr<BackgroundPitfall> job_;
  Scene scene_;
  std::vector<Light> lights_;
  FrameReport report_;
  ui::Input input_{.scene = scene_, .lights = lights_, .features = {}, .report = report_};
};

TEST_F(PitfallJob, MeasuresBrokenFixedAndWhereItHides) {
  const ui::PitfallInput got = run("stereographic-pole");
  EXPECT_EQ(got.note, "");
  PitfallBench bench(lab_->renderer(), lab_->device());
  const PitfallResult r =
      judge_pitfall(load_pitfall("stereographic-pole"), kBackgroundSize, bench.limits(), bench.rounding(),
                    [&](const Settings& drawn, const Settings& meant) { return bench.measure(drawn, meant); });
  EXPECT_EQ(got.broken, r.broken);
  EXPECT_EQ(got.fixed, r.fixed);
  EXPECT_EQ(got.blind, r.blind);
  ASSERT_TRUE(got.blind);
}

TEST_F(PitfallJob, AlongItsPathTheFailureComesAndGoesAndTheFixHolds) {
  const ui::PitfallInput got = run("near-plane-cut");
  ASSERT_EQ(got.path_broken.size(), ui::kPathPoints);
  EXPECT_LE(got.path_broken.front(), 0.001);
  EXPECT_LE(got.path_broken.back(), 0.001);
  EXPECT_GE(*std::max_element(got.path_broken.begin(), got.path_broken.end()), 0.99);
  EXPECT_LE(*std::max_element(got.path_fixed.begin(), got.path_fixed.end()), 0.001);
}

TEST_F(PitfallJob, NothingIsMeasuredWhileTheWindowIsBusyOrNoneIsOpen) {
  ui::Requests r;
  job_->update(preset("start").make(), r, true);
  EXPECT_FALSE(job_->busy());
  r.pitfall.id = "near-plane-cut";
  for (int i = 0; i < 5; ++i) job_->update(preset("start").make(), r, false);
  job_->fill(input_);
  EXPECT_FALSE(input_.pitfall->broken);
  EXPECT_TRUE(job_->busy());
  r.pitfall.id = "";
  job_->update(preset("start").make(), r, true);
  EXPECT_FALSE(job_->busy());
}

}  // namespace
}  // namespace gbl::test
