// What the window does between two frames, without a window: what is drawn, and what stays when something is wrong.
#include "app/viewer.h"

#include "tests/app/viewer_fixture.h"
#include "tests/shader_copy.h"

namespace gbl::test {
namespace {

class Viewers : public ViewerTest {};

TEST_F(Viewers, DrawsOnlyWhatIsVisibleAndOnlyOnce) {
  const Settings s = yard_settings();
  update(s, showing({View::final, View::normal}));
  EXPECT_NE(texture(View::final), 0u);
  EXPECT_NE(texture(View::normal), 0u);
  EXPECT_EQ(texture(View::albedo), 0u) << "a hidden view costs nothing";
  mark(View::final), mark(View::normal);
  update(s, showing({View::final, View::albedo}));
  EXPECT_NE(texture(View::albedo), 0u) << "drawn as soon as it is looked at";
  EXPECT_TRUE(marked(View::final));
  EXPECT_TRUE(marked(View::normal));
  Settings other = s;
  other.ambient = 0.3;
  update(other, showing({View::final}));
  EXPECT_FALSE(marked(View::final)) << "new settings, new picture";
  EXPECT_TRUE(marked(View::normal)) << "hidden now";
  update(other, showing({View::final, View::normal}));
  EXPECT_FALSE(marked(View::normal)) << "and stale when it is looked at again";
}

TEST_F(Viewers, AWireChangesTheFinalPictureOnly) {
  Settings s = yard_settings();
  update(s, showing({View::final, View::normal}));
  const Image plain = lab_->image_of(View::final);
  mark(View::normal);
  s.view.volumes = VolumeOverlay::picked;
  s.view.pick = 30;
  update(s, showing({View::final, View::normal}));
  EXPECT_FALSE(lab_->image_of(View::final) == plain);
  EXPECT_TRUE(marked(View::normal));
}

TEST_F(Viewers, InvalidSettingsKeepTheOldPictureAndSayWhy) {
  const Settings good = yard_settings();
  update(good, showing_all());
  const Image before = lab_->image_of(View::final);
  Settings bad = good;
  bad.camera.far = bad.camera.near;
  bad.size = {80, 45};
  for (int k = 0; k < 3; ++k) {
    update(bad, showing_all());
    EXPECT_NE(message().find("camera.far"), std::string::npos) << message();
    EXPECT_TRUE(lab_->image_of(View::final) == before);
    EXPECT_EQ(lab_->drawn(), good);
  }
  update(good, showing_all());
  EXPECT_EQ(message(), "");
  EXPECT_TRUE(lab_->image_of(View::final) == before);
}

TEST_F(Viewers, InvalidSettingsAtTheStartAreSaidAndMended) {
  Settings s = yard_settings();
  s.camera.far = s.camera.near;
  update(s, showing_all());
  EXPECT_NE(message().find("camera.far"), std::string::npos) << message();
  EXPECT_EQ(texture(View::final), 0u);
  s = yard_settings();
  update(s, showing_all());
  EXPECT_EQ(message(), "");
  EXPECT_NE(texture(View::final), 0u);
}

// Programs that these settings need do not compile. Nothing of the old picture may go, not even when another size was
// asked for, and views that come into sight later show the old frame.
TEST_F(Viewers, ABrokenVariantKeepsTheOldPicture) {
  ShaderCopy copy;
  copy.insert("shaders/light_fullscreen.frag", "void main", "this is no GLSL;");
  const Settings good = yard_settings();
  update(good, showing({View::final}));
  const Image before = lab_->image_of(View::final);
  Settings bad = good;
  bad.lights.method = LightMethod::fullscreen;
  bad.layout = Layout::nclgl;
  bad.size = {80, 45};
  bad.lights.count = 4;
  update(bad, showing_all());
  EXPECT_NE(message().find("shaders/light_fullscreen.frag:"), std::string::npos) << message();
  ASSERT_NE(texture(View::final), 0u);
  EXPECT_TRUE(lab_->image_of(View::final) == before);
  EXPECT_EQ(viewer_->input(0).lights.size(), 64u) << "the lights are those of the picture";
  ASSERT_NE(texture(View::material), 0u);
  const Image material = lab_->image_of(View::material), counts = lab_->image_of(View::lights_per_pixel);
  update(good, showing_all());
  EXPECT_TRUE(lab_->image_of(View::material) == material);
  EXPECT_TRUE(lab_->image_of(View::lights_per_pixel) == counts);
}

TEST_F(Viewers, AFailedReloadHoldsNothingUp) {
  ShaderCopy copy;
  Settings s = yard_settings();
  update(s, showing({View::final}));
  copy.insert("shaders/shade.glsl", "Lighting shade(", "this is no GLSL;");
  s.ambient = 0.4;  // in the same moment
  ui::Requests reload = showing({View::final});
  reload.reload_shaders = true;
  update(s, reload);
  EXPECT_NE(message().find("shaders/shade.glsl:"), std::string::npos) << message();
  EXPECT_EQ(lab_->drawn(), s) << "the last good program draws the new settings";
  copy.restore("shaders/shade.glsl");
  update(s, reload);
  EXPECT_EQ(message(), "shaders read again");
}

TEST_F(Viewers, ASavedShaderIsReadAgainByItself) {
  ShaderCopy copy;
  const Settings s = yard_settings();
  update(s, showing({View::final}));
  const Image before = lab_->image_of(View::final);
  copy.insert("shaders/shade.glsl", "lane arriving = arriving_share", "  light.colour *= 0.5;");
  update(s, showing({View::final}));
  EXPECT_FALSE(lab_->image_of(View::final) == before);
}

// Window = headless: the same Lab calls, whatever was drawn before.
TEST_F(Viewers, PixelsAreThoseOfTheHeadlessCommands) {
  for (const char* id : {"start", "nclgl-fixed"}) {
    Settings s = preset(id).make();
    s.scene = "yard", s.camera = yard_settings().camera, s.size = {160, 90};
    Settings before = s;
    before.lights.count = 9, before.size = {64, 36};
    update(before, showing_all(), true);
    update(before, showing_all());
    update(s, showing_all());
    settle(s, showing_all());  // the reference is there
    Lab headless(FeatureSet{});
    headless.show("yard", std::make_shared<const Scene>(make_yard()));
    headless.draw(s);
    for (const ViewRow& v : views()) {
      if (!why_missing(v.view, s).empty()) continue;
      if (needs_truth(v.view)) {
        EXPECT_TRUE(headless.draw_truth_view(v.view, true));
      } else {
        headless.draw_measured_view(v.view, {.overlays = v.view == View::final});
      }
      EXPECT_TRUE(headless.image_of(v.view) == lab_->image_of(v.view)) << id << ": " << v.id;
    }
  }
}

// What is true is worked out once; how it is drawn changes the error at once.
TEST_F(Viewers, TheErrorFollowsTheSettings) {
  Settings s = yard_settings();
  s.view.error.of = ErrorOf::normal;
  const auto mean_error = [&](NormalEncoding e) {
    s.normal.encoding = e;
    update(s, showing({View::error}));
    settle(s, showing({View::error}));
    const ui::Input in = viewer_->input(0);
    EXPECT_TRUE(in.error.has_value());
    EXPECT_EQ(in.truth_progress, 1);
    return in.error ? in.error->mean : 0;
  };
  const double coarse = mean_error(NormalEncoding::oct8), fine = mean_error(NormalEncoding::oct16);
  EXPECT_GT(coarse, 0.01);  // degrees; most of the yard faces along an axis, which every encoding has a code for
  EXPECT_LT(fine, coarse / 10);
  s.view.error.scale = ErrorScale::with_sign;
  mark(View::error);
  EXPECT_EQ(mean_error(NormalEncoding::oct16), fine);
  EXPECT_FALSE(marked(View::error)) << "another scale, other colours";
}

TEST_F(Viewers, NoReferenceIsBegunWhileSomethingMovesOrNobodyLooks) {
  Settings s = yard_settings();
  update(s, showing({View::error}), true);
  EXPECT_EQ(texture(View::error), 0u);
  update(s, showing({View::final}));
  settle(s, showing({View::final}));
  EXPECT_EQ(texture(View::error), 0u);
  EXPECT_FALSE(viewer_->input(0).error.has_value());
}

TEST_F(Viewers, AProbeAnswersForThePixelAskedFor) {
  const Settings s = yard_settings();
  ui::Requests r = showing({View::final});
  for (const glm::ivec2 pixel : {glm::ivec2(80, 60), {0, 0}, {159, 89}}) {
    r.probe = pixel;
    std::optional<PixelProbe> probe;
    for (int k = 0; k < 200 && !(probe && probe->pixel == pixel); ++k) {
      update(s, r);
      probe = viewer_->input(0).probe;
      glFinish();
    }
    ASSERT_TRUE(probe);
    const Picture lit = picture_of(*lab_->targets().frame.texture(Stores::lit));
    const glm::vec4 texel = lit.texels[size_t(s.size.y - 1 - pixel.y) * s.size.x + pixel.x];
    EXPECT_EQ(probe->surface(), texel.a == 1);
    EXPECT_EQ(probe->vector(ProbeField::lit), glm::vec3(texel));
  }
  r.probe.reset();
  update(s, r);
  EXPECT_FALSE(viewer_->input(0).probe);
}

TEST_F(Viewers, ASceneThatCannotBeReadKeepsTheOldOne) {
  const Settings good = yard_settings();
  update(good, showing({View::final}));
  const Image before = lab_->image_of(View::final);
  Settings bad = good;
  bad.scene = "builtin:nowhere";
  for (int k = 0; k < 3; ++k) {
    update(bad, showing({View::final}));
    viewer_->finish_loading();
  }
  EXPECT_NE(message().find("nowhere"), std::string::npos) << message();
  EXPECT_TRUE(lab_->image_of(View::final) == before);
  EXPECT_FALSE(viewer_->busy());
}

}  // namespace
}  // namespace gbl::test
