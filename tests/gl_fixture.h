#pragma once
// What the GL tests share: one context per process, a small scene, and a stage that draws settings and reads back all
// that is stored.
#include <gtest/gtest.h>
#include <map>
#include <memory>

#include "app/headless.h"
#include "renderer/gl/device.h"
#include "renderer/gl/misuse.h"
#include "renderer/options/presets.h"
#include "renderer/passes/frame.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/mesh_builder.h"
#include "tests/picture.h"

namespace gbl::test {

// Needs a context; what is missing is an Error and fails the test. Features that a test switches off come back here.
class GlTest : public ::testing::Test {
 protected:
  // Here, not in SetUp(), so that fixtures may have members that make names of OpenGL.
  GlTest() { static const HeadlessContext context; }
  void SetUp() override {
    gl::probe_device({});
    glGetError();
  }
  void TearDown() override {
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    for (const std::string& what : gl::take_misuse()) ADD_FAILURE() << what;
  }
};

// A yard of 40 x 40 on y = 0 with boxes, a ball, and walls towards all four sides: cheap to draw, and unlike flat
// ground it hides no direction. The lights stand at y = 3. `origin` moves all of it upwards, lights and camera too.
inline Scene make_yard(double origin = 0) {
  Scene s;
  s.name = "yard";
  Mesh ground = make_box({0, -1, 0}, {40, 0, 40}, 0.25);
  append(ground, make_box({0, 0, 0}, {40, 5, 1}, 0.25), glm::dmat4(1));    // faces +Z
  append(ground, make_box({8, 0, 34}, {14, 2, 35}, 0.25), glm::dmat4(1));  // faces -Z, too
  append(ground, make_box({0, 0, 1}, {1, 5, 40}, 0.25), glm::dmat4(1));    // faces +X
  s.meshes = {ground, make_box({-1.5, 0, -1.5}, {1.5, 4, 1.5}, 0.5), make_ellipsoid({3, 3, 3}, 32, 16)};
  s.materials = {{.name = "ground", .base_colour = {0.6f, 0.55f, 0.5f, 1}, .roughness = 0.7f},
                 {.name = "red", .base_colour = {0.8f, 0.2f, 0.1f, 1}, .roughness = 0.3f},
                 {.name = "white", .base_colour = {1, 1, 1, 1}, .roughness = 0.45f}};
  const auto place = [&](const char* name, int mesh, int material, glm::dvec3 at) {
    glm::dmat4 world_from_object(1);
    world_from_object[3] = glm::dvec4(at + glm::dvec3(0, origin, 0), 1);
    s.instances.push_back({name, mesh, material, world_from_object});
  };
  place("ground", 0, 0, {0, 0, 0});
  place("box", 1, 1, {10, 0, 12});
  place("box", 1, 2, {28, 0, 20});
  place("ball", 2, 2, {20, 3, 24});
  s.light_grid = {.extent = {40, 40}, .height = origin + 3, .pivot = {20, 20}};
  s.bounds = bounds_of(s);
  s.camera.position = {22, origin + 9, 46};
  s.camera.orientation = orientation_from_yaw_pitch(5, -22);
  s.camera.near = 0.5, s.camera.far = 200;
  return s;
}

// Of a scene under its own lights, everything stored and summed in floats: what is left is what the test is about.
inline Settings float_settings(const Scene& scene, glm::ivec2 size = {192, 108}) {
  Settings s;
  s.scene = scene.name;
  s.size = size;
  s.camera = scene.camera;
  s.lights.source = LightSource::scene, s.lights.method = LightMethod::fullscreen;
  s.layout = Layout::float32, s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::view32f;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
  return s;
}

inline const GpuScene& yard() {
  static const GpuScene scene(std::make_shared<const Scene>(make_yard()));
  return scene;
}
inline const GpuScene& terrain() {
  static const GpuScene scene(std::make_shared<const Scene>(build_terrain()));
  return scene;
}

// Settings for a scene of the tests: 160 x 90 and light sums that accuracy can be judged in.
inline Settings settings_for(const GpuScene& scene, glm::ivec2 size = {160, 90}) {
  Settings s = preset("start").make();
  s.camera = &scene == &terrain() ? s.camera : scene.scene().camera;
  s.size = size;
  s.lights.cull = LightCull::flip_safe;
  s.lights.volume.clip = VolumeClip::none;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
  s.lights.seed = 1, s.exposure = 1;  // of the first screen they are there to please
  s.view = {};
  return s;
}

// The light alone: no ambient light, black where no surface is.
inline Settings light_alone(Settings s) {
  s.ambient = 0;
  s.background.fill = BackgroundFill::black;
  return s;
}

inline Picture picture_of(const gl::Texture& t) {
  const std::vector<float> values = gl::read_rgba32f(t);
  Picture p{t.size, std::vector<glm::vec4>(values.size() / 4)};
  std::memcpy(p.texels.data(), values.data(), values.size() * sizeof(float));
  return p;
}

// The texels as they are stored, whatever the format (depth and integers too).
inline std::vector<uint8_t> stored_bytes(const gl::Texture& t) {
  const gl::GlFormat& f = gl::gl_format(t.format);
  std::vector<uint8_t> bytes(16u * t.size.x * t.size.y, 0);  // no format needs more
  glBindTexture(GL_TEXTURE_2D, t.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, f.format, f.type, bytes.data());
  return bytes;
}

// Everything a frame has stored, `lit` included, in the order of attachments().
inline std::vector<std::vector<uint8_t>> stored(const Targets& targets) {
  std::vector<std::vector<uint8_t>> out;
  for (const Attachment& a : targets.frame.attachments()) out.push_back(stored_bytes(*targets.frame.texture(a.stores)));
  return out;
}

// The views that a frame alone can show: all but those that need the reference (reference_gl_test draws these).
inline std::vector<View> frame_views() {
  std::vector<View> out;
  for (const ViewRow& v : views())
    if (!needs_truth(v.view)) out.push_back(v.view);
  return out;
}

// A renderer with targets of its own.
struct Stage {
  explicit Stage(const GpuScene& s) : scene(s) {}
  const GpuScene& scene;
  Renderer renderer;
  Targets targets;

  FrameReport draw(const Settings& s) { return renderer.render(s, scene, targets); }
  Picture lit(const Settings& s) {
    draw(s);
    return picture_of(*targets.frame.texture(Stores::lit));
  }
  PairCounts pairs(const Settings& s) {
    FrameReport report = draw(s);
    renderer.count_pairs(s, scene, targets, true);
    renderer.collect(targets, report, true);
    return report.pairs.value();
  }
  Image view(View v, const Settings& s, const ViewOptions& options = {}) {
    renderer.draw_view(v, s, scene, targets, options);
    const gl::Texture& t = targets.canvases.drawn_view(v)->texture;
    return image_from_gl_rows(t.size, gl::read_rgba8(t));
  }
};

// A stage per scene for tests that draw many settings: programs are compiled once.
inline Stage& shared_stage(const GpuScene& scene) {
  static std::map<const GpuScene*, Stage> stages;
  return stages.try_emplace(&scene, scene).first->second;
}

// Calls `each` for every row of E whose feature this device has.
template <class E, class Each>
void for_each_row(Each each) {
  for (const ValueRow& r : rows<E>())
    if (gl::device().features.has(r.needs)) each(static_cast<E>(r.value), r);
}

}  // namespace gbl::test
