// At which size the window draws, and when: slow frames, motion and rest, and what the lab learns from times.
#include "tests/app/viewer_fixture.h"

namespace gbl::test {
namespace {

class ViewerPace : public ViewerTest {};

// The lab is made to believe in a slow machine, so that nothing here takes long.
TEST_F(ViewerPace, AFramePredictedTooSlowIsDrawnReducedWithABanner) {
  Settings s = yard_settings({320, 180});
  s.lights.method = LightMethod::fullscreen;
  update(s, showing({View::final}));
  EXPECT_EQ(banner(), "");
  settle(s, showing({View::final}));
  lab_->cost().learn(LightMethod::fullscreen, 1e6, 2000);  // 2 microseconds a pair, halved by what was learnt before
  s.ambient = 0.1;
  update(s, showing({View::final}));
  const glm::ivec2 drawn = lab_->drawn().size;
  EXPECT_LT(drawn.x, 300);
  EXPECT_GE(drawn.y, 64);
  EXPECT_NEAR(double(drawn.x) / drawn.y, 320.0 / 180, 0.03) << "not distorted";
  EXPECT_NE(banner().find("predicted"), std::string::npos) << banner();
  EXPECT_NE(banner().find(fmt::format("drawn at {}x{}", drawn.x, drawn.y)), std::string::npos) << banner();
  Settings small = s;
  small.size = drawn;
  EXPECT_EQ(lab_->drawn(), small) << "nothing else is changed";
}

// After a frame that took forever, as when the machine has slept: nobody need touch the window.
TEST_F(ViewerPace, APictureThatWasMadeSmallForNothingBecomesLargeAgainByItself) {
  Settings s = yard_settings({320, 180});
  update(s, showing({View::final}));
  settle(s, showing({View::final}));
  const Image before = lab_->image_of(View::final);
  lab_->cost().learn(s.lights.method, 1e6, 3600e3);
  s.ambient = 0.1;
  update(s, showing({View::final}));
  EXPECT_EQ(lab_->drawn().size, glm::ivec2(113, 64));
  EXPECT_NE(banner(), "");
  for (int k = 0; k < 10; ++k) {
    settle(s, showing({View::final}));
    update(s, showing({View::final}));
  }
  EXPECT_EQ(lab_->drawn().size, s.size);
  EXPECT_EQ(banner(), "");
  s.ambient = yard_settings().ambient;
  update(s, showing({View::final}));
  EXPECT_TRUE(lab_->image_of(View::final) == before);
}

// Of an answer that is late the lab must not learn what the frame drawn since would cost.
TEST_F(ViewerPace, TheLabLearnsAFramesTimeFromThatFrame) {
  Settings heavy = yard_settings({320, 180});
  heavy.lights.method = LightMethod::fullscreen;
  heavy.lights.count = 256;
  Settings light = heavy;
  light.lights.count = 8;
  const auto predicted_ms = [&] { return lab_->cost().predict_ms(*lab_->resolve(light)); };
  for (int k = 0; k < 6; ++k) {  // as long as the first guess still tells
    lab_->draw(heavy);
    lab_->collect(true);
  }
  const double before = predicted_ms();
  for (int k = 0; k < 6; ++k) {
    lab_->draw(heavy);
    glFinish();
    lab_->draw(light);     // its own answer is not there yet
    lab_->collect(false);  // the heavy frame's is: 32 times as long
  }
  EXPECT_LT(predicted_ms(), 4 * before);
}

TEST_F(ViewerPace, MovingHalvesTheSizeOfASlowPictureAndRestGivesItBack) {
  if (!lab_->device().software) GTEST_SKIP() << "only a software driver is given smaller pictures while moving";
  Settings s = yard_settings();
  s.lights.method = LightMethod::fullscreen;
  lab_->cost().learn(LightMethod::fullscreen, 1e6, 1000);  // 500 ns a pair: 460 ms, slow but no cause for a banner
  const ui::Requests all = showing_all();
  update(s, all, true);
  EXPECT_EQ(lab_->drawn().size, s.size / 2);
  EXPECT_EQ(banner(), "");
  EXPECT_TRUE(viewer_->busy());
  EXPECT_EQ(viewer_->input(0).images[0].size, s.size / 2);
  lab_->cost().learn(LightMethod::fullscreen, 1e6, 1000);
  s.time_s = 1;
  update(s, all, true);
  EXPECT_EQ(lab_->drawn().size, s.size / 2);
  update(s, all, false);  // the same settings, but at rest
  EXPECT_EQ(lab_->drawn(), s);
  EXPECT_EQ(viewer_->input(0).images[0].size, s.size);
  settle(s, all);
  EXPECT_TRUE(lab_->report().pairs) << "at rest pairs are counted";
}

TEST_F(ViewerPace, APictureThatWasNotReducedWhileMovingIsCountedAtRest) {
  Settings s = yard_settings({64, 36});
  update(s, showing({View::final}), true);
  EXPECT_EQ(lab_->drawn().size, s.size);
  update(s, showing({View::final}), false);
  settle(s, showing({View::final}));
  ASSERT_TRUE(lab_->report().pairs);
  EXPECT_TRUE(lab_->report().pairs->lit);
}

TEST_F(ViewerPace, MovingOnWhileCountsAreUnderWayEndsAtRest) {
  Settings s = yard_settings({64, 36});
  update(s, showing({View::final}), false);  // counts under way
  for (int k = 1; k < 4; ++k) {
    s.time_s = k;
    update(s, showing({View::final}), true);
  }
  settle(s, showing({View::final}));
  Stage stage(yard());
  EXPECT_EQ(lab_->report().pairs->shaded, stage.pairs(s).shaded) << "and they are those of the last picture";
}

}  // namespace
}  // namespace gbl::test
