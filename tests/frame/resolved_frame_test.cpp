#include "renderer/frame/resolved_frame.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include "renderer/frame/estimate.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

std::shared_ptr<const Scene> empty_scene() { return std::make_shared<const Scene>(); }

TEST(ResolvedFrame, NothingIsLeftToChoose) {
  Settings s = preset("start").make();
  s.layout = Layout::auto_;
  s.lights.method = LightMethod::auto_;
  const ResolvedFrame f = resolve_frame(s, Scene{}, {});
  EXPECT_NE(f.settings.layout, Layout::auto_);
  EXPECT_NE(f.settings.lights.method, LightMethod::auto_);
  EXPECT_FALSE(f.method_reason.empty());
  EXPECT_FALSE(f.choices.empty());
  EXPECT_FALSE(f.attachments.empty());
  EXPECT_EQ(f.gbuffer_bytes_per_pixel, gbuffer_bytes_per_pixel(f.settings));
  EXPECT_EQ(f.shading, shading_of(f.settings.lights.method));
  EXPECT_EQ(f.lights.size(), lights_of(s, Scene{}).size());
}

TEST(ResolvedFrame, SaysTheSameAsTheSettingsOfEveryPreset) {
  for (const Preset& p : presets()) {
    const ResolvedFrame f = resolve_frame(p.make(), Scene{}, {});
    EXPECT_EQ(f.stencil, needs_stencil(f.settings)) << p.id;
    EXPECT_EQ(f.lighting_tests_depth, lighting_tests_depth(f.settings)) << p.id;
    EXPECT_EQ(f.lighting_has_depth, find(f.attachments, Stores::light_depth) != nullptr) << p.id;
    EXPECT_EQ(f.light_sum_is_begun, sum_begins_in_geometry(f.settings)) << p.id;
    EXPECT_EQ(f.normal_in_material, f.shading == Shading::deferred && !find(f.attachments, Stores::normal)) << p.id;
  }
}

TEST(Resolver, WorksAFrameOutOnceUntilSomethingChanges) {
  Resolver resolver;
  const auto scene = empty_scene(), other = empty_scene();
  Settings a = preset("start").make(), b = preset("nclgl").make();
  const auto first = resolver.get(a, scene, {});
  a.view.pick = 3;  // only what is looked at
  EXPECT_EQ(resolver.get(a, scene, {}), first);
  const auto second = resolver.get(b, scene, {});
  EXPECT_NE(second, first);
  EXPECT_EQ(resolver.get(a, scene, {}), first) << "two settings in turn";
  EXPECT_EQ(resolver.get(b, scene, {}), second);
  EXPECT_EQ(resolver.resolved(), 2);
  EXPECT_NE(resolver.get(a, other, {}), first) << "another scene";
  FeatureSet features;
  features.add(Feature::compute);
  EXPECT_NE(resolver.get(a, scene, features), first) << "another device";
  a.time_s = 1;
  const auto later = resolver.get(a, scene, {});
  EXPECT_EQ(resolver.resolved(), 5);
  EXPECT_NE(later->lights[0].position, first->lights[0].position);
}

TEST(Resolver, DoesNotKeepAScene) {
  Resolver resolver;
  auto scene = empty_scene();
  const std::weak_ptr<const Scene> alive = scene;
  resolver.get(preset("start").make(), scene, {});
  scene.reset();
  EXPECT_TRUE(alive.expired()) << "a model of gigabytes would stay";
}

TEST(Resolver, AChangedRigIsReadAgain) {
  const TemporaryFolder folder("resolver");
  const auto write = [&](int count) {
    std::ofstream file(folder / "rig.json");
    file << R"({"version": 1, "lights": [)";
    for (int i = 0; i < count; ++i) file << (i ? "," : "") << R"({"kind": "point", "position": [0,1,0], "candela": 1})";
    file << "]}";
  };
  const auto advance = [&](int seconds) {
    const auto time = std::filesystem::last_write_time(folder / "rig.json");
    std::filesystem::last_write_time(folder / "rig.json", time + std::chrono::seconds(seconds));
  };
  Settings s;
  s.lights.source = LightSource::rig;
  s.lights.rig = (folder / "rig.json").string();
  Resolver resolver;
  const auto scene = empty_scene();
  write(1);
  EXPECT_EQ(resolver.get(s, scene, {})->lights.size(), 1u);
  write(2);
  advance(2);  // file times are coarse
  EXPECT_EQ(resolver.get(s, scene, {})->lights.size(), 2u);
}

// Of many lights some stand for all: what they say is near what all of them say. A quarter: shares of the picture scatter
// by about their mean, the mean of 512 of them by 1/sqrt(512) = 4 %; a quarter is six times that.
TEST(LightsInView, ASampleStandsForManyLights) {
  Settings s = preset("start").make();
  for (const int count : {2000, 16384}) {
    s.lights.count = count;
    const std::vector<Light> lights = lights_of(s, Scene{});
    LightsInView exact;
    for (size_t from = 0; from < lights.size(); from += 500) {  // small enough to be looked at one by one
      const std::vector<Light> some(lights.begin() + long(from),
                                    lights.begin() + long(std::min(lights.size(), from + 500)));
      const LightsInView part = lights_in_view(s, some);
      exact.reached += part.reached, exact.under_volumes += part.under_volumes, exact.under_quads += part.under_quads;
    }
    const LightsInView sampled = lights_in_view(s, lights);
    EXPECT_EQ(sampled.lights, count);
    EXPECT_NEAR(sampled.under_volumes / exact.under_volumes, 1, 0.25) << count;
    EXPECT_NEAR(sampled.under_quads / exact.under_quads, 1, 0.25) << count;
  }
}

// A deep mesh of so many triangles, and another object that shares it.
Scene deep_scene(size_t triangles, bool shared) {
  Scene scene;
  scene.textures = {{.name = "heights", .size = {1, 1}, .rgba = {0, 0, 0, 255}}};
  scene.materials = {{.name = "deep", .height_texture = {0}, .height_depth = 0.1f}};
  scene.meshes.resize(1);
  scene.meshes[0].vertices.resize(3);
  for (size_t i = 0; i < 3 * triangles; ++i) scene.meshes[0].indices.push_back(static_cast<uint32_t>(i % 3));
  scene.instances = {{"wall", 0, 0, glm::dmat4(1)}};
  if (shared) scene.instances.push_back({"other wall", 0, 0, glm::dmat4(1)});
  return scene;
}

bool says(const ResolvedFrame& f, std::string_view what) {
  return std::any_of(f.choices.begin(), f.choices.end(), [&](const std::string& c) { return contains(c, what); });
}

TEST(Tessellated, AreDeepObjectsWithMeshesOfTheirOwn) {
  Settings s = preset("start").make();
  s.height_map = HeightMap::on;
  s.tessellation = {TessellationMode::uniform, 64};
  ResolvedFrame f = resolve_frame(s, deep_scene(100, false), {});
  EXPECT_EQ(f.tessellated, std::vector<int>{0});
  EXPECT_EQ(f.settings.tessellation.level, 64);
  f = resolve_frame(s, deep_scene(100, true), {});
  EXPECT_TRUE(f.tessellated.empty());
  EXPECT_TRUE(says(f, "2 objects are not tessellated"));
  f = resolve_frame(s, Scene{}, {});
  EXPECT_TRUE(says(f, "no material of the scene has a height map"));
  s.tessellation.mode = TessellationMode::off;
  EXPECT_TRUE(resolve_frame(s, deep_scene(100, false), {}).tessellated.empty());
}

TEST(Tessellated, AreCutNoFinerThanMemoryAllows) {
  Settings s = preset("start").make();
  s.height_map = HeightMap::on;
  s.tessellation = {TessellationMode::by_distance, 64};
  const ResolvedFrame f = resolve_frame(s, deep_scene(2000, false), {});
  const int level = f.settings.tessellation.level;
  EXPECT_LE(2000 * tessellated_triangles(level), kMostTessellated);
  EXPECT_GT(2000 * tessellated_triangles(level + 1), kMostTessellated);
  EXPECT_TRUE(says(f, "tessellation.level=18 instead of 64")) << level;
}

}  // namespace
}  // namespace gbl
