#pragma once
// A viewer over the yard, without a window.
#include <thread>

#include "app/viewer.h"
#include "tests/gl_fixture.h"

namespace gbl::test {

inline Settings yard_settings(glm::ivec2 size = {160, 90}) {
  Settings s = settings_for(yard(), size);
  s.scene = "yard";
  return s;
}

inline ui::Requests showing(std::initializer_list<View> visible) {
  ui::Requests r;
  for (const View v : visible) r.visible[static_cast<int>(v)] = true;
  return r;
}

inline ui::Requests showing_all() {
  ui::Requests r;
  r.visible.fill(true);
  return r;
}

class ViewerTest : public GlTest {
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
    for (int k = 0; k < 2000 && viewer_->busy(); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the reference is worked out on other threads
      glFinish();
      update(s, r);
    }
    EXPECT_FALSE(viewer_->busy());
  }

  std::unique_ptr<Lab> lab_;
  std::unique_ptr<Viewer> viewer_;
};

}  // namespace gbl::test
