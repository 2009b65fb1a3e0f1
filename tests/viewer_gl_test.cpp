// What the window does between two frames, without a window: what is drawn, at which size, and what stays when something
// is wrong.
#include "app/viewer.h"

#include "renderer/resources.h"
#include "tests/gl_fixture.h"
#include "tests/shader_copy.h"

namespace gbl::test {
namespace {

Settings yard_settings(glm::ivec2 size = {160, 90}) {
  Settings s = settings_for(yard(), size);
  s.scene = "yard";
  return s;
}

ui::Requests showing(std::initializer_list<View> visible) {
  ui::Requests r;
  for (const View v : visible) r.visible[static_cast<int>(v)] = true;
  return r;
}

ui::Requests showing_all() {
  ui::Requests r;
  r.visible.fill(true);
  return r;
}

class Viewers : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
    lab_->show("yard", std::make_shared<const Scene>(make_yard()));
    viewer_ = std::make_unique<Viewer>(*lab_);
  }
  void update(const Settings& s, const ui::Requests& r, bool moving = false) { viewer_->update(s, r, moving); }
  std::string message() const { return viewer_->input(0).message; }
  std::string banner() const { return viewer_->input(0).banner; }
  uint64_t texture(View v) const { return viewer_->input(0).images[static_cast<int>(v)].texture; }

  // Puts a colour of its own into a view's picture: if it is still there later, the view was not drawn again.
  void mark(View v) {
    gl::Framebuffer f = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, f.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, GLuint(texture(v)), 0);
    glDisable(GL_SCISSOR_TEST), glColorMask(true, true, true, true);
    constexpr float kMagenta[] = {1, 0, 1, 1};
    glClearBufferfv(GL_COLOR, 0, kMagenta);
  }
  bool marked(View v) const {
    const Image image = lab_->image_of(v);
    return image.rgba[0] == 255 && image.rgba[1] == 0 && image.rgba[2] == 255;
  }
  // Updates without input until no more is to come.
  void settle(const Settings& s, const ui::Requests& r) {
    for (int k = 0; k < 200 && viewer_->busy(); ++k) {
      glFinish();
      update(s, r);
    }
    EXPECT_FALSE(viewer_->busy());
  }

  std::unique_ptr<Lab> lab_;
  std::unique_ptr<Viewer> viewer_;
};

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
  copy.insert("shaders/shade.glsl", "vec3 arriving", "  light.colour *= 0.5;");
  update(s, showing({View::final}));
  EXPECT_FALSE(lab_->image_of(View::final) == before);
}

// The lab is made to believe in a slow machine, so that nothing here takes long.
TEST_F(Viewers, AFramePredictedTooSlowIsDrawnReducedWithABanner) {
  Settings s = yard_settings({320, 180});
  s.lights.method = LightMethod::fullscreen;
  update(s, showing({View::final}));
  EXPECT_EQ(banner(), "");
  settle(s, showing({View::final}));
  lab_->cost().learn(1e6, 2000);  // 2 microseconds a pair, halved by what was learnt before
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

// Of an answer that is late the lab must not learn what the frame drawn since would cost.
TEST_F(Viewers, TheLabLearnsAFramesTimeFromThatFrame) {
  Settings heavy = yard_settings({320, 180});
  heavy.lights.method = LightMethod::fullscreen;
  heavy.lights.count = 256;
  Settings light = heavy;
  light.lights.count = 8;
  const auto predicted_ms = [&] { return lab_->cost().predict_ms(light, lights_of(light, lab_->scene())); };
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

TEST_F(Viewers, MovingHalvesTheSizeOfASlowPictureAndRestGivesItBack) {
  if (!lab_->device().software) GTEST_SKIP() << "only a software driver is given smaller pictures while moving";
  Settings s = yard_settings();
  s.lights.method = LightMethod::fullscreen;
  lab_->cost().learn(1e6, 1000);  // 500 ns a pair: 460 ms, slow but no cause for a banner
  const ui::Requests all = showing_all();
  update(s, all, true);
  EXPECT_EQ(lab_->drawn().size, s.size / 2);
  EXPECT_EQ(banner(), "");
  EXPECT_TRUE(viewer_->busy());
  EXPECT_EQ(viewer_->input(0).images[0].size, s.size / 2);
  lab_->cost().learn(1e6, 1000);
  s.time_s = 1;
  update(s, all, true);
  EXPECT_EQ(lab_->drawn().size, s.size / 2);
  update(s, all, false);  // the same settings, but at rest
  EXPECT_EQ(lab_->drawn(), s);
  EXPECT_EQ(viewer_->input(0).images[0].size, s.size);
  settle(s, all);
  EXPECT_TRUE(lab_->report().pairs) << "at rest pairs are counted";
}

TEST_F(Viewers, APictureThatWasNotReducedWhileMovingIsCountedAtRest) {
  Settings s = yard_settings({64, 36});
  update(s, showing({View::final}), true);
  EXPECT_EQ(lab_->drawn().size, s.size);
  update(s, showing({View::final}), false);
  settle(s, showing({View::final}));
  ASSERT_TRUE(lab_->report().pairs);
  EXPECT_TRUE(lab_->report().pairs->lit);
}

TEST_F(Viewers, MovingOnWhileCountsAreUnderWayEndsAtRest) {
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
    Lab headless(FeatureSet{});
    headless.show("yard", std::make_shared<const Scene>(make_yard()));
    headless.draw(s);
    for (const ViewRow& v : views()) {
      if (!why_missing(v.view, s).empty()) continue;
      headless.draw_view(v.view, {.overlays = v.view == View::final});
      EXPECT_TRUE(headless.image_of(v.view) == lab_->image_of(v.view)) << id << ": " << v.id;
    }
  }
}

TEST_F(Viewers, AProbeAnswersForThePixelAskedFor) {
  const Settings s = yard_settings();
  ui::Requests r = showing({View::final});
  for (const glm::ivec2 pixel : {glm::ivec2(80, 60), {0, 0}, {159, 89}}) {
    r.probe = pixel;
    std::optional<ui::PixelProbe> probe;
    for (int k = 0; k < 200 && !(probe && probe->pixel == pixel); ++k) {
      update(s, r);
      probe = viewer_->input(0).probe;
      glFinish();
    }
    ASSERT_TRUE(probe);
    const Picture lit = picture_of(*lab_->targets().texture(Stores::lit));
    const glm::vec4 texel = lit.texels[size_t(s.size.y - 1 - pixel.y) * s.size.x + pixel.x];
    EXPECT_EQ(probe->surface, texel.a == 1);
    EXPECT_EQ(probe->lit, glm::vec3(texel));
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
