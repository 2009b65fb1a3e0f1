// Models made by others, when they lie beside the project. None of them is part of it.
#include <gtest/gtest.h>

#include "tests/gltf/gltf_fixture.h"
#include "tests/test_paths.h"

namespace gbl::test {
namespace {

struct Model {
  const char* file;
  size_t drawn, unique;  // triangles
  size_t instances, textures, warnings;
};

constexpr Model kModels[] = {
    {"FlightHelmet/FlightHelmet.gltf", 94722, 94722, 6, 15, 0},
    {"WaterBottle/WaterBottle.gltf", 4510, 4510, 1, 4, 0},
    {"NormalTangentTest/NormalTangentTest.glb", 7774, 7774, 1, 3, 0},
    {"OrientationTest/OrientationTest.glb", 524, 524, 13, 0, 0},
    {"AlphaBlendModeTest/AlphaBlendModeTest.glb", 61, 61, 9, 9, 0},
    {"TextureSettingsTest/TextureSettingsTest.gltf", 72, 72, 10, 8, 0},
    {"TextureTransformTest/TextureTransformTest.gltf", 24, 18, 12, 5, 0},
    {"VertexColorTest/VertexColorTest.gltf", 36, 36, 2, 2, 0},
    {"AnisotropyStrengthTest/AnisotropyStrengthTest.glb", 97240, 97240, 50, 1, 1},  // anisotropy is not drawn
    {"BoxWithSpaces/Box With Spaces.gltf", 12, 12, 1, 3, 0},
    {"LightsPunctual/gltf_KHR_lights_punctual_test.glb", 14, 14, 2, 0, 0},
    {"SimpleSparseAccessor/SimpleSparseAccessor.gltf", 12, 12, 1, 0, 0},
    {"Fox/Fox.glb", 576, 576, 1, 1, 2},  // animations are not played, skins are in their rest pose
    {"HomeTheater/home-theater.gltf", 7915, 7915, 20, 0, 0},
    {"Terrain/terrain.gltf", 5202, 5202, 1, 0, 0},
    {"Ambulance/Ambulance.glb", 2588, 2588, 27, 0, 0},
    {"BoxTexturedEmbedded/BoxTextured.gltf", 12, 12, 1, 1, 0},
    {"DungeonHall/DungeonHall.gltf", 55724, 10059, 140, 1, 0},
};

std::filesystem::path models() { return test::source_folder().parent_path() / "shared/models"; }
bool absent() { return !std::filesystem::exists(models()); }
constexpr const char* kAbsent = "no folder of test models beside the project";

TEST(GltfModels, TriangleForTriangle) {
  if (absent()) GTEST_SKIP() << kAbsent;
  for (const Model& model : kModels) {
    SCOPED_TRACE(model.file);
    const Scene scene = load_gltf(models() / model.file);
    size_t drawn = 0, unique = 0;
    for (const Mesh& mesh : scene.meshes) unique += mesh.indices.size() / 3;
    for (const Instance& i : scene.instances) drawn += scene.meshes[static_cast<size_t>(i.mesh)].indices.size() / 3;
    EXPECT_EQ(drawn, model.drawn);
    EXPECT_EQ(unique, model.unique);
    EXPECT_EQ(scene.instances.size(), model.instances);
    EXPECT_EQ(scene.textures.size(), model.textures);
    EXPECT_EQ(scene.warnings.size(), model.warnings) << (scene.warnings.empty() ? "" : scene.warnings[0]);
    EXPECT_GT(glm::length(scene.bounds.extent()), 0);
  }
}

TEST(GltfModels, FoxStandsUprightInItsPose) {
  if (absent()) GTEST_SKIP() << kAbsent;
  const Scene scene = load_gltf(models() / "Fox/Fox.glb");
  const glm::dvec3 size = scene.bounds.extent();
  EXPECT_GT(size.z, size.y);  // longer than high, higher than wide
  EXPECT_GT(size.y, 2 * size.x);
  EXPECT_NEAR(scene.bounds.min.y, 0, 2);  // on the ground
}

TEST(GltfModels, LightsOfThreeKinds) {
  if (absent()) GTEST_SKIP() << kAbsent;
  const Scene scene = load_gltf(models() / "LightsPunctual/gltf_KHR_lights_punctual_test.glb");
  int seen[3] = {};
  for (const Light& light : scene.lights) {
    ++seen[static_cast<int>(light.kind)];
    EXPECT_NEAR(glm::length(light.direction), 1, 1e-12);
  }
  for (const int count : seen) EXPECT_EQ(count, 1);
  EXPECT_EQ(load_gltf(models() / "DungeonHall/DungeonHall.gltf").lights.size(), 8u);
}

}  // namespace
}  // namespace gbl::test
