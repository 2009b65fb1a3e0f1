// What a preset needs is compiled before it is chosen.
#include "app/background_warm_up.h"

#include "renderer/passes/programs.h"
#include "tests/app/viewer_fixture.h"
#include "tests/passes/all_pairs.h"

namespace gbl::test {
namespace {

class WarmUp : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
    job_ = std::make_unique<BackgroundWarmUp>(*lab_);
  }
  // -> how many pieces it took
  int run(const ui::Requests& r) {
    Settings now = preset("start").make();
    now.size = kWindow;
    int pieces = 0;
    do job_->update(now, r, true), ++pieces;
    while (job_->busy() && pieces < 1000);
    EXPECT_FALSE(job_->busy());
    return pieces;
  }
  int compiled() { return lab_->renderer().programs_compiled(); }

  static constexpr glm::ivec2 kWindow{320, 180};
  std::unique_ptr<Lab> lab_;
  std::unique_ptr<BackgroundWarmUp> job_;
};

TEST_F(WarmUp, AfterItNoPresetCompilesAnything) {
  const std::vector<View> seen = {View::final, View::normal, View::lights_per_pixel};
  ui::Requests r;
  for (const View v : seen) r.visible[static_cast<size_t>(v)] = true;
  const int pieces = run(r);
  EXPECT_GT(pieces, static_cast<int>(presets().size())) << "a frame and its views are pieces of their own";
  const int before = compiled();
  EXPECT_GT(before, 40);
  EXPECT_LE(before, static_cast<int>(ProgramCache::kMost)) << "else the first ones would be forgotten";
  for (const Preset& p : presets()) {
    Settings s = p.make();
    s.size = kWindow;
    lab_->draw(s);
    for (const View v : seen)
      if (why_missing(v, s).empty()) lab_->draw_view(v, {.overlays = lab_->is_main(v)});
    EXPECT_EQ(compiled(), before) << p.id;
  }
}

TEST_F(WarmUp, NothingIsDrawnWhileTheWindowIsTouched) {
  for (int k = 0; k < 10; ++k) job_->update(preset("start").make(), showing({View::final}), false);
  EXPECT_FALSE(job_->busy());
  EXPECT_EQ(compiled(), 0);
}

TEST_F(WarmUp, ThePicturesOfTheWindowStay) {
  Settings s = yard_settings();
  lab_->show("yard", std::make_shared<const Scene>(make_yard()));
  lab_->draw(s);
  lab_->draw_view(View::final);
  const Image before = lab_->image_of(View::final);
  run(showing({View::final}));
  EXPECT_TRUE(lab_->image_of(View::final) == before);
  EXPECT_EQ(lab_->scene_name(), "yard");
  lab_->draw_view(View::final);
  EXPECT_TRUE(lab_->image_of(View::final) == before);
}

// The window itself may fill the cache while the job stands still.
TEST_F(WarmUp, WhatItHoldsIsGivenBackWhenOthersHaveFilledTheCache) {
  Settings now = preset("start").make();
  now.size = kWindow;
  job_->update(now, showing({View::final}), true);
  EXPECT_TRUE(job_->busy());
  lab_->show("yard", std::make_shared<const Scene>(make_yard()));
  Pcg32 random(1);
  while (lab_->renderer().has_room_for_programs()) {
    Settings s = random_choices(random, {32, 18});
    s.scene = "yard";
    lab_->draw(s);
  }
  const int held = gl::live_names(gl::Kind::vertex_array);
  job_->update(now, showing({View::final}), true);
  EXPECT_FALSE(job_->busy());
  EXPECT_LT(gl::live_names(gl::Kind::vertex_array), held) << "its scene";
}

}  // namespace
}  // namespace gbl::test
