// The advisor beside the window's picture: the answer of advise() at once, and always an end.
#include "app/background_advice.h"

#include "app/background.h"
#include "tests/app/viewer_fixture.h"

namespace gbl::test {
namespace {

class BackgroundAdvices : public ViewerTest {
 protected:
  const ui::AdvisorInput& shown() const { return *viewer_->input(0).advisor; }
  bool frame(const Settings& s, const ui::AdvisorRequest& asked, bool quiet = true) {
    ui::Requests r = showing({View::final});
    r.advisor = asked;
    viewer_->update(s, r, false);
    viewer_->measure(s, r, quiet);
    return viewer_->busy();
  }
  void frames_until(const Settings& s, const ui::AdvisorRequest& asked, size_t tried) {
    for (int k = 0; k < 5000 && shown().tried < tried; ++k) frame(s, asked);
    ASSERT_GE(shown().tried, tried);
  }
  Settings settled() {
    Settings s = yard_settings();
    frame(s, {});
    settle(s, showing({View::final}));
    return s;
  }
  static constexpr ErrorBudget kBudget{8 / 255.0, 0.02};  // that some set-ups hold in the yard and some do not
  static constexpr ui::AdvisorRequest kOpen{.open = true, .budget = kBudget, .cost = AdviceCost::bytes};
  static constexpr ui::AdvisorRequest kRun{.open = true, .budget = kBudget, .cost = AdviceCost::bytes, .run = true};
  static constexpr ui::AdvisorRequest kStop{.open = true, .budget = kBudget, .cost = AdviceCost::bytes, .stop = true};
};

TEST_F(BackgroundAdvices, TheAnswerIsThatOfAdviseAtOnceAndThePictureStays) {
  const Settings s = settled();
  const Image before = lab_->image_of(View::final);
  frame(s, kRun);
  EXPECT_TRUE(viewer_->busy());
  for (int k = 0; k < 100000 && frame(s, kOpen); ++k) {
  }
  EXPECT_FALSE(viewer_->busy());
  ASSERT_TRUE(shown().advice) << shown().note;
  EXPECT_TRUE(lab_->image_of(View::final) == before);

  AdviceBench bench(*lab_, kBudget, AdviceCost::bytes);
  const JudgeFn judge = [&](const Settings& setup, int camera) {
    bench.start_bound(setup, camera);
    bench.step(true);
    return bench.bound();
  };
  const std::atomic<bool> never{false};
  const Advice at_once = advise(
      as_measured(s), lab_->scene(), kBudget, AdviceCost::bytes, lab_->limits(), judge,
      [](const Settings&) { return 0.0; }, [](const std::string&) {}, never);
  const auto expect_same = [](const std::optional<AdvisedSetup>& a, const std::optional<AdvisedSetup>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(a->settings, b->settings);
    EXPECT_EQ(a->cost, b->cost);
    EXPECT_EQ(a->proof.camera, b->proof.camera);
    EXPECT_EQ(a->proof.worst.worst, b->proof.worst.worst);
  };
  ASSERT_TRUE(at_once.best);
  EXPECT_FALSE(at_once.left_out.empty());
  expect_same(shown().advice->best, at_once.best);
  expect_same(shown().advice->runner_up, at_once.runner_up);
  EXPECT_EQ(shown().advice->left_out, at_once.left_out);
}

TEST_F(BackgroundAdvices, NothingIsMeasuredUnlessItIsQuiet) {
  const Settings s = settled();
  frame(s, kRun, false);
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(frame(s, kOpen, false));
  EXPECT_LE(shown().tried, 1u) << "its first question waits";
}

TEST_F(BackgroundAdvices, ItStopsWhereverItIs) {
  const Settings s = settled();
  for (const size_t tried : {0, 1, 3}) {
    frame(s, kRun);
    frames_until(s, kOpen, tried);
    frame(s, kStop);
    EXPECT_FALSE(viewer_->busy());
    EXPECT_NE(shown().note.find("Stopped"), std::string::npos);
  }
  frame(s, kRun);
  frame(s, {});
  EXPECT_FALSE(viewer_->busy()) << "closed";
  frame(s, kRun);
  Settings other = s;
  other.lights.seed += 1;
  frame(other, kOpen);
  EXPECT_FALSE(shown().running);
  EXPECT_NE(shown().note.find("lights.seed"), std::string::npos) << shown().note;
  frame(s, kRun);
  lab_->show("yard", std::make_shared<const Scene>(make_yard(1)));
  frame(s, kOpen);
  EXPECT_FALSE(shown().running) << "another scene";
  frame(s, kRun);
  frames_until(s, kOpen, 2);
  viewer_.reset();  // while it runs: it wakes up and ends
}

TEST_F(BackgroundAdvices, WhatCannotBeMeasuredIsItsReasonToStop) {
  const Settings s = settled();
  lab_->cost().learn(LightMethod::volumes, 1e6, 50000);  // the machine is believed to be very slow
  lab_->cost().learn(LightMethod::volumes, 1e6, 50000);
  frame(s, kRun);
  for (int k = 0; k < 1000 && frame(s, kOpen); ++k) {
  }
  EXPECT_FALSE(shown().running);
  EXPECT_FALSE(shown().advice);
  EXPECT_NE(shown().note.find("predicted"), std::string::npos) << shown().note;
}

}  // namespace
}  // namespace gbl::test
