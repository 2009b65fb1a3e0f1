// The list's small pictures are drawn while it is open, and show what the entry draws.
#include "app/pitfall_pictures.h"

#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class PitfallPicturesGl : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
  }
  // Draws all of them; how many steps it took.
  int run(PitfallPictures& job) {
    ui::Requests r;
    r.pitfall.list = true;
    int steps = 0;
    do job.update(settings_, r, true), ++steps;
    while (job.busy() && steps < 1000);
    job.fill(input_);
    return steps;
  }
  std::unique_ptr<Lab> lab_;
  Settings settings_ = preset("start").make();
  Scene scene_;
  std::vector<Light> lights_;
  FrameReport report_;
  ui::Input input_{.scene = scene_, .lights = lights_, .features = {}, .report = report_};
};

std::vector<uint8_t> texels(uint64_t texture) {
  std::vector<uint8_t> rgba(4u * ui::kPitfallPicture.x * ui::kPitfallPicture.y);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture));
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

TEST_F(PitfallPicturesGl, EveryEntryHasBothOfItsSides) {
  PitfallPictures job(*lab_);
  const std::vector<PitfallEntry> entries = load_pitfalls();
  EXPECT_EQ(run(job), static_cast<int>(2 * entries.size())) << "one picture a step";
  for (const PitfallEntry& e : entries) {
    const auto it = input_.pitfall_pictures->find(e.id);
    ASSERT_NE(it, input_.pitfall_pictures->end()) << e.id;
    EXPECT_NE(it->second.broken, 0u) << e.id;
    EXPECT_NE(it->second.fixed, 0u) << e.id;
  }
}

TEST_F(PitfallPicturesGl, APictureIsOfItsEntry) {
  PitfallPictures job(*lab_);
  run(job);
  const PitfallEntry e = load_pitfall("near-plane-cut");
  const ui::PitfallPicture picture = input_.pitfall_pictures->at(e.id);
  for (const auto& [side, texture] :
       {std::pair(PitfallSide::broken, picture.broken), {PitfallSide::fixed, picture.fixed}}) {
    Settings s = settings_of(e, side);
    s.size = ui::kPitfallPicture;
    lab_->open(s.scene);
    lab_->draw(s);
    const View view = view_by_id(s.view.main).view;
    lab_->draw_view(view, {.overlays = true});
    Image expected = lab_->image_of(view);
    const std::vector<uint8_t> got = texels(texture);
    const auto row = static_cast<std::ptrdiff_t>(4 * expected.size.x);
    for (int y = 0; y < expected.size.y; ++y)  // GL's rows go up
      EXPECT_TRUE(std::equal(got.begin() + row * y, got.begin() + row * (y + 1),
                             expected.rgba.begin() + row * (expected.size.y - 1 - y)))
          << "row " << y;
  }
}

TEST_F(PitfallPicturesGl, NothingIsDrawnWhileTheListIsClosedOrTheWindowIsBusy) {
  PitfallPictures job(*lab_);
  job.update(settings_, {}, true);
  EXPECT_FALSE(job.busy());
  ui::Requests r;
  r.pitfall.list = true;
  for (int i = 0; i < 5; ++i) job.update(settings_, r, false);
  job.fill(input_);
  EXPECT_TRUE(input_.pitfall_pictures->empty());
}

}  // namespace
}  // namespace gbl::test
