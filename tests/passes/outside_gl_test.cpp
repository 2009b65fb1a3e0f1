// The frame from outside: points stand where the G-buffer says, and of the light's mesh only what the method draws.
#include "renderer/passes/outside.h"

#include "renderer/frame/frame_lights.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Outside : public GlTest {
 protected:
  Image seen(const Settings& s, const OutsideView& v, View colours = View::normal) {
    stage_->draw(s);
    stage_->view(colours, s);
    const gl::Texture depth = gl::make_texture({.size = v.size, .format = Format::d32f, .label = "depth"});
    const Canvas into = make_canvas({.size = v.size, .label = "outside"}, &depth);
    stage_->renderer.draw_outside(v, colours, s, stage_->scene, stage_->targets, into);
    return image_from_gl_rows(v.size, gl::read_rgba8(into.texture));
  }
  void SetUp() override {
    GlTest::SetUp();
    stage_.emplace(yard());
  }
  std::optional<Stage> stage_;
};

size_t differing(const Image& a, const Image& b) {
  size_t n = 0;
  for (size_t i = 0; i < a.rgba.size(); i += 4)
    n += !std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                     a.rgba.begin() + static_cast<std::ptrdiff_t>(i + 3),
                     b.rgba.begin() + static_cast<std::ptrdiff_t>(i));
  return n;
}

bool same(const Image& a, size_t i, const Image& b, size_t k) {
  return std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                    a.rgba.begin() + static_cast<std::ptrdiff_t>(i + 3),
                    b.rgba.begin() + static_cast<std::ptrdiff_t>(k));
}

TEST_F(Outside, FromTheCameraItselfThePointsAreThePicture) {
  Settings s = settings_for(yard(), {160, 90});
  s.lights.count = 0;
  for (const PositionSource source : {PositionSource::depth, PositionSource::world32f}) {
    s.position.source = source;
    OutsideView v{s.camera, s.size};
    v.from.near = 2 * s.camera.near;  // the near plane's quad stands before it
    const Image points = seen(s, v), picture = stage_->view(View::normal, s);
    size_t compared = 0, unlike = 0;
    for (int y = 3; y < 87; ++y)
      for (int x = 3; x < 157; ++x) {
        const size_t i = 4 * (static_cast<size_t>(y) * 160 + static_cast<size_t>(x));
        const bool sky = picture.rgba[i] < 40 && picture.rgba[i + 2] > 60 && picture.rgba[i + 2] < 90;
        if (sky) continue;
        ++compared;
        bool found = false;  // a point is two pixels wide: the nearest of its neighbours covers it
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            found = found ||
                    same(points, i, picture, 4 * (static_cast<size_t>(y + dy) * 160 + static_cast<size_t>(x + dx)));
        unlike += !found;
      }
    EXPECT_GT(compared, 5000u);
    EXPECT_EQ(unlike, 0u) << row(source).id;
  }
}

TEST_F(Outside, FacesThatAreCulledAreLeftOut) {
  Settings s = settings_for(yard(), {160, 90});
  s.lights.count = 4;
  s.lights.cull = LightCull::flip_safe;
  const Light light = lights_of(s, yard().scene())[0];
  s.camera.position = light.position + glm::dvec3(0, 0.2, 0.4) * light.range;  // inside
  OutsideView v{s.camera, {320, 180}};
  v.from.position += glm::dvec3(0, 0, 3 * light.range);
  v.from.far = 1000;
  const Image drawn = seen(s, v);
  s.lights.cull = LightCull::back;
  const Image culled = seen(s, v);
  EXPECT_GT(differing(drawn, culled), 2000u) << "from inside all faces are back faces";
  s.lights.cull = LightCull::none;
  EXPECT_LT(differing(seen(s, v), drawn), 50u) << "and none of them is a front face";
  s.lights.method = LightMethod::fullscreen;
  s.lights.cull = LightCull::back;
  EXPECT_LT(differing(seen(s, v), drawn), 50u) << "a method without meshes culls none";
}

TEST_F(Outside, TheFrameIsAsItWas) {
  const Settings s = settings_for(yard(), {160, 90});
  stage_->draw(s);
  const Image before = stage_->view(View::final, s);
  OutsideView v{s.camera, {64, 36}};
  v.from.position.y += 20;
  seen(s, v);
  EXPECT_TRUE(stage_->view(View::final, s) == before);
}

}  // namespace
}  // namespace gbl::test
