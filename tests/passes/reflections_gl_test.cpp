// What mirrors show against the rays of the reference.
#include <glm/gtc/matrix_transform.hpp>

#include "app/stability_bench.h"
#include "renderer/frame/validate.h"
#include "renderer/passes/judging.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class ReflectionsGl : public GlTest {
 protected:
  static StabilityBench& bench() {
    static Renderer renderer;
    static StabilityBench b(renderer, gl::probe_device({}));
    return b;
  }
};

// The yard of the tests without textures, with a mirror that leans against the air, and a ball of chrome or glass.
SweepSetup mirrored_yard() {
  auto scene = std::make_shared<Scene>(make_yard());
  scene->name = "test:mirrors";
  for (Material& m : scene->materials) m.roughness = 0.6f;
  const int mirror = static_cast<int>(scene->materials.size());
  scene->materials.push_back({.name = "mirror", .base_colour = {0.9f, 0.9f, 0.9f, 1}, .roughness = 0.05f, .metal = 1});
  Mesh sheet;
  for (const glm::vec2 c : {glm::vec2(-6, 0), {6, 0}, {-6, 8}, {6, 8}})
    sheet.vertices.push_back({.position = {c.x, c.y, 0}, .normal = {0, 0, 1}});
  sheet.indices = {0, 1, 2, 1, 3, 2};
  set_tangents(sheet);
  scene->meshes.push_back(sheet);
  glm::dmat4 at = glm::rotate(glm::translate(glm::dmat4(1), {17, 1, 14}), 0.2, {0, 1, 0});
  scene->instances.push_back({"mirror", static_cast<int>(scene->meshes.size()) - 1, mirror, at});
  Light lamp;
  lamp.position = {16, 9, 20}, lamp.range = 60;
  scene->lights = {lamp};
  scene->bounds = bounds_of(*scene);
  Settings s = float_settings(*scene);
  s.shading.model = ShadingModel::ggx;
  s.reflections = Reflections::on;
  return {s, scene};
}

size_t off_pixels(const Measured& m, double by) {
  size_t off = 0;
  for (size_t i = 0; i < m.drawn.lit.size(); ++i)
    off += glm::distance(glm::dvec3(m.drawn.lit[i]), m.truth->lit[i]) > by;
  return off;
}

// A plane's picture is right to the pixel; a cube's is not, where what it mirrors is near.
TEST_F(ReflectionsGl, APlaneShowsTheTruthAndACubeComesNearIt) {
  SweepSetup s = mirrored_yard();
  const Measured planar = bench().measure(s);
  s.settings.reflect.method = ReflectMethod::cube;
  const Measured cube = bench().measure(s);
  s.settings.reflect.method = ReflectMethod::none;
  const Measured none = bench().measure(s);
  const size_t mirror = off_pixels(none, 0.01);
  EXPECT_GT(mirror, 300u) << "pixels of the mirror";
  EXPECT_LT(off_pixels(planar, 0.01), mirror / 20) << "edges of what it shows";
  EXPECT_GT(off_pixels(cube, 0.01), mirror / 4);
}

// The picture behind the plane is the frame of the mirrored camera, to the bit.
TEST_F(ReflectionsGl, APlanesPictureIsTheMirroredCamerasFrame) {
  const SweepSetup setup = mirrored_yard();
  const GpuScene scene(setup.scene);
  Renderer renderer;
  Targets targets, alone;
  renderer.render(setup.settings, scene, targets);
  ASSERT_EQ(targets.mirrors.flat.size(), 1u);
  const Mirror mirror = mirrors_of(*setup.scene)[0];
  Settings s = setup.settings;
  s.camera = mirrored(s.camera, mirror.plane);
  s.reflections = Reflections::off;
  alone.cut = {.object = mirror.object, .behind = mirror.plane};
  renderer.render(s, scene, alone);
  EXPECT_EQ(gl::read_rgba32f(targets.mirrors.flat[0].texture), gl::read_rgba32f(*alone.frame.texture(Stores::lit)));
}

TEST_F(ReflectionsGl, WhatIsBehindTheMirrorIsCutAway) {
  SweepSetup s = mirrored_yard();
  const size_t right = off_pixels(bench().measure(s), 0.01);
  s.settings.mistakes = {Mistake::mirror_without_clip_plane};
  EXPECT_GT(off_pixels(bench().measure(s), 0.01), right + 50) << "the wall behind it stands before the camera";
}

TEST_F(ReflectionsGl, EveryMethodShowsTheSame) {
  SweepSetup s = mirrored_yard();
  const Measured full = bench().measure(s);
  size_t drawn = 0;
  for (const ValueRow& r : rows<LightMethod>()) {
    s.settings.lights.method = static_cast<LightMethod>(r.value);
    if (s.settings.lights.method == LightMethod::auto_ || !validate(s.settings, bench().limits()).empty()) continue;
    const Measured m = bench().measure(s);
    size_t differ = 0;
    for (size_t i = 0; i < m.drawn.lit.size(); ++i)
      differ += glm::distance(m.drawn.lit[i], full.drawn.lit[i]) > 1.0f / 255;
    EXPECT_LE(differ, m.drawn.lit.size() / 1000) << r.id;
    ++drawn;
  }
  EXPECT_GE(drawn, 8u);
}

// Six sides do not depend on the camera: they are drawn once, and again when a light has moved.
TEST_F(ReflectionsGl, ACubeIsDrawnWhenItChanges) {
  SweepSetup setup = mirrored_yard();
  setup.settings.reflect.method = ReflectMethod::cube;
  const GpuScene scene(setup.scene);
  Renderer renderer;
  Targets targets, anew;
  Settings s = setup.settings;
  const int first = renderer.render(s, scene, targets).draw_calls;
  const int still = renderer.render(s, scene, targets).draw_calls;
  EXPECT_LT(still, first - 12);
  s.camera.position.x += 2;
  EXPECT_EQ(renderer.render(s, scene, targets).draw_calls, still);
  renderer.render(s, scene, anew);
  EXPECT_EQ(read_lit(targets), read_lit(anew));
  s.time_s = 5;
  EXPECT_EQ(renderer.render(s, scene, targets).draw_calls, still) << "its light stands still";
  s.ambient = 0.3;
  EXPECT_EQ(renderer.render(s, scene, targets).draw_calls, first);
  s.lights.source = LightSource::generated, s.lights.count = 4;
  renderer.render(s, scene, targets);
  s.time_s = 6;
  EXPECT_EQ(renderer.render(s, scene, targets).draw_calls, first) << "these move";
}

TEST_F(ReflectionsGl, OffTheirSettingsChangeNoBitAndNoMemory) {
  SweepSetup s = mirrored_yard();
  s.settings.reflections = Reflections::off;
  const std::vector<glm::vec3> before = bench().measure(s).drawn.lit;
  s.settings.reflect = {ReflectMethod::cube, ReflectSize::s64};
  EXPECT_EQ(bench().measure(s).drawn.lit, before);
  const GpuScene scene(s.scene);
  Renderer renderer;
  Targets targets;
  const double without = renderer.render(s.settings, scene, targets).mib;
  s.settings.reflections = Reflections::on;
  EXPECT_GT(renderer.render(s.settings, scene, targets).mib, without);
  s.settings.reflections = Reflections::off;
  EXPECT_EQ(renderer.render(s.settings, scene, targets).mib, without);
}

// A clear ball is stored, and what comes through it is judged: bent once instead of twice it is wrong, without it more.
TEST_F(ReflectionsGl, GlassIsStoredAndRefracts) {
  SweepSetup s = mirrored_yard();
  auto scene = std::make_shared<Scene>(*s.scene);
  Material& m = scene->materials.back();
  m = {.name = "glass", .roughness = 0.05f, .alpha_mode = AlphaMode::blend, .transmission = 1};
  m.base_colour = {1, 1, 1, 0.2f};
  const auto ball = std::find_if(scene->meshes.begin(), scene->meshes.end(),
                                 [](const Mesh& mesh) { return mesh.vertices.size() > 200; });
  ASSERT_NE(ball, scene->meshes.end());
  scene->instances.back().mesh = static_cast<int>(ball - scene->meshes.begin());
  scene->instances.back().world_from_object = glm::translate(glm::dmat4(1), {17, 5, 24});
  scene->bounds = bounds_of(*scene);
  scene->name = s.settings.scene = "test:glass";
  s.scene = scene;
  const Measured refracted = bench().measure(s);
  s.settings.reflect.method = ReflectMethod::none;
  const Measured none = bench().measure(s);
  const size_t pixels = off_pixels(none, 0.01);
  EXPECT_GT(pixels, 300u);
  double error = 0, without = 0;
  for (size_t i = 0; i < none.drawn.lit.size(); ++i) {
    error += glm::distance(glm::dvec3(refracted.drawn.lit[i]), refracted.truth->lit[i]);
    without += glm::distance(glm::dvec3(none.drawn.lit[i]), none.truth->lit[i]);
  }
  EXPECT_LT(error, 0.7 * without);
}

}  // namespace
}  // namespace gbl::test
