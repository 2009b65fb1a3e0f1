// Sweeps beside the window's picture: point by point, with the rows of a sweep at once, and without a trace in it.
#include "app/background_sweep.h"

#include "tests/app/viewer_fixture.h"

namespace gbl::test {
namespace {

class BackgroundSweeps : public ViewerTest {
 protected:
  const ui::StabilityInput& shown() const { return *viewer_->input(0).stability; }
  bool frame(ui::StabilityRequest asked, bool quiet = true) {
    ui::Requests r = showing({View::final});
    r.stability = std::move(asked);
    viewer_->update(settings_, r, false);
    viewer_->measure(settings_, r, quiet);
    return viewer_->busy();
  }
  void settle_picture() {
    settings_ = yard_settings();
    frame({});
    settle(settings_, showing({View::final}));
  }
  void run_to_end(const ui::StabilityRequest& asked) {
    for (int k = 0; k < 20000 && frame(asked); ++k) {
    }
    EXPECT_FALSE(viewer_->busy());
  }
  Settings settings_;
};

void expect_same(const SweepResult& a, const SweepResult& b) {
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (size_t c = 0; c < a.curves.size(); ++c) {
    const CurveResult &x = a.curves[c], &y = b.curves[c];
    EXPECT_EQ(x.not_drawn, y.not_drawn);
    ASSERT_EQ(x.rows.size(), y.rows.size());
    for (size_t i = 0; i < x.rows.size(); ++i) {
      EXPECT_EQ(x.rows[i].x, y.rows[i].x);
      EXPECT_EQ(x.rows[i].value, y.rows[i].value) << x.curve << " at " << x.rows[i].x;
    }
    ASSERT_EQ(x.judged.size(), y.judged.size());
    for (size_t i = 0; i < x.judged.size(); ++i) EXPECT_EQ(x.judged[i].verdict.holds, y.judged[i].verdict.holds);
  }
}

TEST_F(BackgroundSweeps, RowsAreThoseOfASweepAtOnceAndThePictureStays) {
  settle_picture();
  const Image before = lab_->image_of(View::final);
  frame({.open = true, .sweep = "far-plane", .run = true});
  EXPECT_TRUE(viewer_->busy());
  run_to_end({.open = true, .sweep = "far-plane"});
  ASSERT_TRUE(shown().result);
  EXPECT_EQ(shown().done, shown().total);
  StabilityBench bench(lab_->renderer(), lab_->device());
  const std::atomic<bool> never{false};
  const SweepResult at_once = run_sweep(
      sweep("far-plane"), {.limits = bench.limits(), .rounding = bench.rounding()},
      [&](const SweepSetup& s) { return bench.measure(s); }, nullptr, never);
  expect_same(*shown().result, at_once);
  EXPECT_FALSE(at_once.curves[0].judged.empty());
  EXPECT_TRUE(lab_->image_of(View::final) == before);
  lab_->draw(settings_);
  lab_->draw_view(View::final, {.overlays = true});
  EXPECT_TRUE(lab_->image_of(View::final) == before) << "drawn anew it is the same, too";
}

TEST_F(BackgroundSweeps, APointAFrameAtMostAndOnlyWhileItIsQuiet) {
  settle_picture();
  frame({.open = true, .sweep = "far-plane", .run = true}, false);
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(frame({.open = true, .sweep = "far-plane"}, false));
  EXPECT_EQ(shown().done, 0u);
  size_t before = 0;
  for (int k = 0; k < 20000 && shown().done < 10; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the truth is worked out on other threads
    frame({.open = true, .sweep = "far-plane"});
    EXPECT_LE(shown().done, before + 1);
    before = shown().done;
  }
  EXPECT_EQ(shown().done, 10u);
  EXPECT_TRUE(shown().result->curves[0].judged.empty()) << "nothing is judged before the end";
}

TEST_F(BackgroundSweeps, ItStopsWhenAskedOrClosedAndGoesOnWhereItWas) {
  settle_picture();
  const ui::StabilityRequest open{.open = true, .sweep = "far-plane"};
  frame({.open = true, .sweep = "far-plane", .run = true});
  for (int k = 0; k < 20000 && shown().done < 5; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the truth is worked out on other threads
    frame(open);
  }
  frame({.open = true, .sweep = "far-plane", .stop = true});
  EXPECT_FALSE(viewer_->busy());
  EXPECT_EQ(shown().done, 5u);
  EXPECT_NE(shown().note.find("R goes on"), std::string::npos);
  frame({.open = true, .sweep = "far-plane", .run = true});
  EXPECT_TRUE(viewer_->busy());
  EXPECT_GE(shown().done, 5u);
  frame({.sweep = "far-plane"});
  EXPECT_FALSE(viewer_->busy()) << "closed: a window at rest does no work";
  frame({.open = true, .sweep = "near-plane"});
  EXPECT_EQ(shown().done, 0u);
  frame(open);
  EXPECT_GE(shown().done, 5u) << "its points are still there";
}

TEST_F(BackgroundSweeps, AnUnknownSweepIsANote) {
  settle_picture();
  frame({.open = true, .sweep = "no-such-sweep", .run = true});
  EXPECT_NE(shown().note.find("no-such-sweep"), std::string::npos);
  EXPECT_FALSE(viewer_->busy());
}

}  // namespace
}  // namespace gbl::test
