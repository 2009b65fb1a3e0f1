// Files of bent and missing bytes end in an Error or a Scene, in time.
#include <chrono>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/gltf/gltf_fixture.h"
#include "tests/sanitized.h"

namespace gbl::test {
namespace {

#ifndef GBL_MUTATIONS
#define GBL_MUTATIONS 500
#endif
constexpr int kMutations = GBL_MUTATIONS;

// What a renderer takes for granted.
void expect_whole(const Scene& scene) {
  EXPECT_FALSE(scene.instances.empty());
  for (const Instance& i : scene.instances) {
    ASSERT_LT(static_cast<size_t>(i.mesh), scene.meshes.size());
    ASSERT_LT(static_cast<size_t>(i.material), scene.materials.size());
  }
  for (const Mesh& mesh : scene.meshes) {
    ASSERT_FALSE(mesh.indices.empty());
    for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
    for (const Vertex& v : mesh.vertices) {
      ASSERT_LT(std::abs(v.position.x) + std::abs(v.position.y) + std::abs(v.position.z), 1e19f);
      ASSERT_NEAR(glm::length(v.normal), 1, 1e-3);
      ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-3);
      ASSERT_EQ(std::abs(v.tangent.w), 1);
    }
  }
  for (const Texture& t : scene.textures)
    ASSERT_EQ(t.rgba.size(), static_cast<size_t>(t.size.x) * static_cast<size_t>(t.size.y) * 4);
  for (const Material& m : scene.materials)
    for (const TextureUse* use : texture_uses(m)) ASSERT_LT(use->texture, static_cast<int>(scene.textures.size()));
  ASSERT_GT(scene.camera.far, scene.camera.near);
}

// 1 if it loaded.
int try_load(const Bytes& bytes, const std::string& what) {
  SCOPED_TRACE(what);
  try {
    expect_whole(load_gltf_from_memory(bytes, "test"));
    return 1;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return 0;
  }
}

TEST(GltfMutation, SeedsLoadWithoutWarnings) {
  for (const Seed& seed : seeds()) {
    const Scene scene = load_gltf_from_memory(seed.bytes, "test");
    const bool skinned = seed.name.find("skinned") == 0;  // its pose is said, and nothing else
    EXPECT_EQ(scene.warnings.size(), skinned ? 1u : 0u) << seed.name << ": " << scene.warnings.front();
    expect_whole(scene);
  }
}

TEST(GltfMutation, BentBytesEndCleanly) {
  int loaded = 0;
  for (const Seed& seed : seeds()) {
    Pcg32 random(7);
    for (int round = 0; round < kMutations; ++round) {
      Bytes bent = seed.bytes;
      for (uint32_t changes = 1 + random.next() % 4; changes > 0; --changes)
        bent[random.next() % bent.size()] = static_cast<uint8_t>(random.next());
      loaded += try_load(bent, seed.name + " " + std::to_string(round));
    }
  }
  EXPECT_GT(loaded, kMutations / 10);  // else the mutations are too rough to reach the loader
}

TEST(GltfMutation, EveryTruncationEndsCleanly) {
  for (const Seed& seed : seeds())
    for (size_t length = 0; length < seed.bytes.size(); ++length)
      try_load(Bytes(seed.bytes.begin(), seed.bytes.begin() + static_cast<long>(length)),
               seed.name + " cut at " + std::to_string(length));
}

double seconds_to_load(const GltfFile& file, size_t instances) {
  const Bytes bytes = file.glb();
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = load_gltf_from_memory(bytes, "test");
  const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(scene.instances.size(), instances);
  return s;
}

constexpr int kMany = 50'000;
constexpr double kSeconds = 8 * kSlowdown;  // a few, on a slow and busy machine

TEST(GltfMutation, FiftyThousandNodes) {
  GltfFile wide = triangle_file();
  json& nodes = wide.doc["nodes"];
  json& roots = wide.doc["scenes"][0]["nodes"];
  for (int i = 1; i < kMany; ++i) {
    nodes.push_back({{"mesh", 0}, {"translation", {i, 0, 0}}, {"name", "node " + std::to_string(i)}});
    roots.push_back(i);
  }
  EXPECT_LT(seconds_to_load(wide, kMany), kSeconds);
  // One below the other: no recursion may follow them.
  for (int i = 0; i + 1 < kMany; ++i) nodes[static_cast<size_t>(i)]["children"] = {i + 1};
  for (int i = 1; i < kMany; ++i) nodes[static_cast<size_t>(i)]["translation"] = {1e-3, 0, 0};
  roots = {0};
  EXPECT_LT(seconds_to_load(wide, kMany), kSeconds);
}

TEST(GltfMutation, ManyMeshesAccessorsAndMaterials) {
  GltfFile file = triangle_file();
  for (int i = 1; i < kMany / 5; ++i) {
    const int accessor = file.add("accessors", file.doc["accessors"][0]);
    json primitive = position_only(accessor);
    primitive["material"] = file.add("materials", {{"name", "m"}});
    file.place(primitive);
  }
  EXPECT_LT(seconds_to_load(file, kMany / 5), kSeconds);
}

}  // namespace
}  // namespace gbl::test
