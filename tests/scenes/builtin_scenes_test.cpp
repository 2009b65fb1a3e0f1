// What every built-in scene promises, from the table: a new row is tested by itself.
#include "renderer/scenes/builtin_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "renderer/frame/frame_lights.h"
#include "renderer/frame/validate.h"
#include "renderer/light/lights.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/settings_json.h"
#include "tests/scenes/mesh_promises.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

const Scene& scene_of(const BuiltinScene& row) {
  static std::map<std::string, Scene> built;
  const auto found = built.find(row.id);
  return found != built.end() ? found->second : built.emplace(row.id, row.build()).first->second;
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// As chosen in the window: the scene's camera, lights and look over the defaults.
Settings shown(const BuiltinScene& row) {
  Settings s;
  apply_scene(s, std::string("builtin:") + row.id, scene_of(row));
  return s;
}

// A scene that a test is about, and its row.
class EveryScene : public testing::TestWithParam<BuiltinScene> {
 protected:
  const BuiltinScene& row() const { return GetParam(); }
  const Scene& scene() const { return scene_of(row()); }
};

TEST_P(EveryScene, LoadsUnderItsId) {
  EXPECT_EQ(load_scene(std::string("builtin:") + row().id).name, row().id);
  EXPECT_TRUE(scene().warnings.empty());
}

TEST_P(EveryScene, HasMeshesThatKeepTheirPromises) {
  for (const Mesh& mesh : scene().meshes) EXPECT_EQ(broken_promise(mesh), "") << mesh.name;
}

TEST_P(EveryScene, RefersToWhatThereIsByNamesThatDiffer) {
  const Scene& s = scene();
  std::vector<std::string> names;
  for (const Instance& i : s.instances) {
    EXPECT_FALSE(i.name.empty());
    names.push_back(i.name);
    ASSERT_LT(static_cast<size_t>(i.mesh), s.meshes.size()) << i.name;
    ASSERT_LT(static_cast<size_t>(i.material), s.materials.size()) << i.name;
    EXPECT_GT(std::abs(glm::determinant(glm::dmat3(i.world_from_object))), 0) << i.name;
  }
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  EXPECT_EQ(twice, names.end()) << *twice;
  for (const Mesh& m : s.meshes) EXPECT_FALSE(m.name.empty());
  for (const Material& m : s.materials) {
    EXPECT_FALSE(m.name.empty());
    for (const TextureUse* t : texture_uses(m)) EXPECT_LT(t->texture, static_cast<int>(s.textures.size())) << m.name;
    EXPECT_EQ(m.height_texture.texture != kNoTexture, m.height_depth > 0) << m.name;
  }
  for (const Texture& t : s.textures)
    EXPECT_EQ(t.rgba.size() + t.rgba16.size(), static_cast<size_t>(t.size.x) * static_cast<size_t>(t.size.y) * 4)
        << t.name;
}

TEST_P(EveryScene, SharesItsMeshes) {  // a copy of a mesh is an instance, not another mesh
  std::vector<std::string> bytes;
  for (const Mesh& m : scene().meshes)
    bytes.emplace_back(reinterpret_cast<const char*>(m.vertices.data()), m.vertices.size() * sizeof(Vertex));
  std::sort(bytes.begin(), bytes.end());
  EXPECT_EQ(std::adjacent_find(bytes.begin(), bytes.end()), bytes.end());
}

TEST_P(EveryScene, KnowsItsBounds) {
  const Bounds b = bounds_of(scene());
  EXPECT_EQ(scene().bounds.min, b.min);
  EXPECT_EQ(scene().bounds.max, b.max);
  EXPECT_TRUE(finite(b.min) && finite(b.max));
}

TEST_P(EveryScene, HasALookThatIsValidAndSound) {
  Settings patched;
  for (const char* part : {row().look, row().drawing})
    EXPECT_NO_THROW(apply_patch(patched, parse_patch(part, row().id), row().id));
  const Settings s = shown(row());
  for (const Problem& p : validate(s, {})) ADD_FAILURE() << p.path << ": " << p.sentence;
  for (const Unsound& u : unsound_choices(s)) ADD_FAILURE() << u.path << " = " << u.value << ": " << u.pitfall;
}

TEST_P(EveryScene, IsLitByFiniteLights) {
  Settings s = shown(row());
  EXPECT_FALSE(lights_of(s, scene()).empty());
  for (LightSource source : {LightSource::scene, LightSource::generated}) {
    s.lights.source = source;
    for (const Light& l : lights_of(s, scene())) {
      EXPECT_TRUE(finite(l.position) && finite(l.colour) && finite(l.direction));
      EXPECT_GE(std::min({l.colour.x, l.colour.y, l.colour.z}), 0);
      EXPECT_GT(l.range, 0);
      EXPECT_TRUE(std::isfinite(l.range));
      EXPECT_NEAR(glm::length(l.direction), 1, 1e-9);
      EXPECT_GE(l.inner_cos, l.outer_cos);
    }
  }
}

TEST_P(EveryScene, IsBeforeItsCamera) {
  const Camera& camera = scene().camera;
  EXPECT_GT(camera.near, 0);
  EXPECT_GT(camera.far, camera.near);
  const glm::dmat4 clip = clip_from_relative(camera, 16.0 / 9);
  double largest = 0;  // share of the picture within an instance's rectangle
  for (const Instance& i : scene().instances) {
    glm::dvec2 low(1e9), high(-1e9);
    bool before = true;
    for (const Vertex& v : scene().meshes[i.mesh].vertices) {
      const glm::dvec3 p(i.world_from_object * glm::dvec4(glm::dvec3(v.position), 1));
      const glm::dvec4 c = clip * glm::dvec4(p - camera.position, 1);
      before &= c.w > camera.near;
      low = glm::min(low, glm::dvec2(c) / c.w);
      high = glm::max(high, glm::dvec2(c) / c.w);
    }
    const glm::dvec2 seen = glm::max(glm::min(high, 1.0) - glm::max(low, -1.0), 0.0);
    if (before) largest = std::max(largest, seen.x * seen.y / 4);
  }
  EXPECT_GT(largest, 0.005);
}

TEST_P(EveryScene, IsTheSameEachTime) {
  const Scene again = row().build();
  ASSERT_EQ(again.meshes.size(), scene().meshes.size());
  for (size_t i = 0; i < again.meshes.size(); ++i) {
    const std::vector<Vertex>&a = again.meshes[i].vertices, &b = scene().meshes[i].vertices;
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vertex)), 0) << again.meshes[i].name;
    EXPECT_EQ(again.meshes[i].indices, scene().meshes[i].indices);
  }
  ASSERT_EQ(again.textures.size(), scene().textures.size());
  for (size_t i = 0; i < again.textures.size(); ++i) EXPECT_EQ(again.textures[i].rgba, scene().textures[i].rgba);
  ASSERT_EQ(again.instances.size(), scene().instances.size());
  for (size_t i = 0; i < again.instances.size(); ++i)
    EXPECT_EQ(again.instances[i].world_from_object, scene().instances[i].world_from_object);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryScene, testing::ValuesIn(builtin_scenes().begin(), builtin_scenes().end()),
                         [](const auto& given) {
                           std::string id = given.param.id;
                           id.erase(std::remove(id.begin(), id.end(), '-'), id.end());
                           return id;
                         });

TEST(BuiltinScenes, NamesThatAreNotScenesSayWhatThereIs) {
  const std::string typo = error_line(ExitCode::bad_input, [] { load_scene("builtin:terain"); });
  EXPECT_TRUE(contains(typo, "builtin:terain")) << typo;
  EXPECT_TRUE(contains(typo, "did you mean 'terrain'? known: ")) << typo;
  const std::string file = error_line(ExitCode::bad_input, [] { load_scene("duck.glb"); });
  EXPECT_TRUE(contains(file, "duck.glb: is not a built-in scene")) << file;
  EXPECT_TRUE(contains(file, "builtin:terrain")) << file;
}

// Numbers of source 2's public program.
TEST(BuiltinScenes, GridIsThatOfSourceTwo) {
  const Scene s = build_grid();
  ASSERT_EQ(s.instances.size(), 9u);
  for (int k = 0; k < 9; ++k) {
    const glm::dmat4& m = s.instances[k].world_from_object;
    EXPECT_EQ(glm::dvec3(m[3]), glm::dvec3(3 * (k % 3 - 1), -0.5, 3 * (k / 3 - 1)));
    EXPECT_EQ(m[0].x, 0.5);
    EXPECT_EQ(s.instances[k].mesh, s.instances[0].mesh);
  }
  Settings settings;
  apply_scene(settings, "builtin:grid", s);
  const std::vector<Light> lights = lights_of(settings, s);
  ASSERT_EQ(lights.size(), 32u);
  for (const Light& l : lights) {
    EXPECT_TRUE(l.position.y >= -4 && l.position.y < 2 && std::abs(l.position.x) <= 3 && std::abs(l.position.z) <= 3);
    EXPECT_TRUE(l.colour.x >= 0.5 && l.colour.x < 1);
    EXPECT_TRUE(l.range > 3.4 && l.range < 5.2) << l.range;
  }
  EXPECT_EQ(settings.camera.position, glm::dvec3(0, 0, 5));
}

TEST(BuiltinScenes, SpheresAreOneMeshUnderAllKindsOfLight) {
  const Scene s = build_spheres();
  const auto spheres = std::count_if(s.instances.begin(), s.instances.end(), [](auto& i) { return i.mesh == 0; });
  EXPECT_GT(spheres, 200);
  for (LightKind kind : {LightKind::point, LightKind::spot, LightKind::directional})
    EXPECT_TRUE(std::any_of(s.lights.begin(), s.lights.end(), [kind](auto& l) { return l.kind == kind; }));
}

TEST(BuiltinScenes, CityHasHousesOfTheHeightsAskedForAndUnlitWindows) {
  const Scene s = build_city();
  int houses = 0, windows = 0;
  double lowest = 1e9, highest = 0;
  for (const Instance& i : s.instances) {
    if (i.name.rfind("windows ", 0) == 0) windows += s.materials[i.material].unlit;
    if (i.name.rfind("house ", 0) != 0) continue;
    ++houses;
    double top = 0;
    for (const Vertex& v : s.meshes[i.mesh].vertices) top = std::max(top, static_cast<double>(v.position.y));
    lowest = std::min(lowest, top), highest = std::max(highest, top);
  }
  EXPECT_EQ(houses, 144);
  EXPECT_EQ(windows, 144);
  EXPECT_EQ(lowest, 10);
  EXPECT_GT(highest, 50);
  EXPECT_LE(highest, 60);
}

}  // namespace
}  // namespace gbl
