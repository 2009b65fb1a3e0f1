#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {
namespace {

// Of a vertex, where its instance puts it: a mesh that lies far from its origin is moved there.
glm::vec3 placed(const Scene& scene, const glm::vec3& p) {
  return glm::vec3(scene.instances.at(0).world_from_object * glm::dvec4(glm::dvec3(p), 1));
}

const Mesh& only_mesh(const Scene& scene) {
  EXPECT_EQ(scene.meshes.size(), 1u);
  return scene.meshes.at(0);
}

std::vector<glm::vec3> corners(const Mesh& mesh) {
  std::vector<glm::vec3> out;
  for (const uint32_t i : mesh.indices) out.push_back(mesh.vertices[i].position);
  return out;
}

// A primitive with normals, so that vertices stay as they are in the file.
json with_normals(GltfFile& file, int position, size_t count) {
  std::vector<float> up;
  for (size_t i = 0; i < count; ++i) up.insert(up.end(), {0, 0, 2});  // not unit: loading makes it so
  return {{"attributes", {{"POSITION", position}, {"NORMAL", file.numbers(up, "VEC3")}}}};
}

TEST(GltfGeometry, TriangleFromBothKindsOfFile) {
  const GltfFile file = triangle_file();
  for (const Bytes& bytes : {file.glb(), bytes_of(file.gltf()), bytes_of("\xef\xbb\xbf" + file.gltf())}) {
    const Scene scene = load_gltf_from_memory(bytes, "test");
    const Mesh& mesh = only_mesh(scene);
    EXPECT_EQ(corners(mesh), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(scene.bounds.max, glm::dvec3(1, 1, 0));
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    for (const Vertex& v : mesh.vertices) {
      EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
      EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-6);
      EXPECT_EQ(v.colour, glm::vec4(1));
    }
  }
}

TEST(GltfGeometry, MissingNormalsAreFlatAndUnshareVertices) {
  GltfFile file;
  // Two triangles that share an edge and stand at a right angle.
  json primitive = position_only(file.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3"));
  primitive["indices"] = file.numbers<uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  file.place(primitive);
  const Scene scene = file.load();
  const Mesh& mesh = only_mesh(scene);
  ASSERT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.vertices[3].normal, glm::vec3(1, 0, 0));
}

TEST(GltfGeometry, IndicesOfEveryType) {
  const auto check = [](auto zero) {
    using T = decltype(zero);
    GltfFile file;
    json primitive = with_normals(file, file.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"), 3);
    primitive["indices"] = file.numbers<T>({2, 0, 1}, "SCALAR");
    file.place(primitive);
    const Scene scene = file.load();
    EXPECT_EQ(only_mesh(scene).indices, (std::vector<uint32_t>{2, 0, 1}));
    EXPECT_EQ(only_mesh(scene).vertices[0].normal, glm::vec3(0, 0, 1));
  };
  check(uint8_t{0});
  check(uint16_t{0});
  check(uint32_t{0});
}

TEST(GltfGeometry, StripsAndFansWindAsTheSpecificationSays) {
  for (const int mode : {5, 6}) {
    GltfFile file;
    const auto points = mode == 5 ? std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}
                                  : std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0};
    json primitive = position_only(file.numbers(points, "VEC3"));
    primitive["mode"] = mode;
    file.place(primitive);
    const Scene scene = file.load();
    ASSERT_EQ(only_mesh(scene).indices.size(), 9u) << mode;
    for (const Vertex& v : only_mesh(scene).vertices) EXPECT_EQ(v.normal, glm::vec3(0, 0, 1)) << mode;
  }
}

TEST(GltfGeometry, InterleavedAndOffsetData) {
  GltfFile file;
  std::vector<float> rows;  // position, normal, uv: 32 bytes
  for (int i = 0; i < 3; ++i)
    for (const float x : {float(i == 1), float(i == 2), 5.f, 0.f, 0.f, 1.f, i * .25f, i * .5f}) rows.push_back(x);
  Bytes bytes(rows.size() * 4);
  std::memcpy(bytes.data(), rows.data(), bytes.size());
  const int view = file.view(bytes, 32);
  const int position = file.accessor(view, 0, 5126, "VEC3", 3), normal = file.accessor(view, 12, 5126, "VEC3", 3);
  const int uv = file.accessor(view, 24, 5126, "VEC2", 3);
  file.place({{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}});
  const Scene scene = file.load();
  const Vertex& last = only_mesh(scene).vertices.at(2);
  EXPECT_EQ(placed(scene, last.position), glm::vec3(0, 1, 5));
  EXPECT_EQ(last.normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(last.uv, glm::vec2(.5f, 1));
}

TEST(GltfGeometry, SparseValuesReplaceAndStandAlone) {
  for (const bool base : {true, false}) {
    GltfFile file = triangle_file();
    const std::vector<float> moved = {0, 0, 7, 4, 0, 7, 0, 4, 7};
    Bytes bytes(36);
    std::memcpy(bytes.data(), moved.data(), 36);
    json& accessor = file.doc["accessors"][0];
    const int indices = file.view({0, 0, 1, 0, 2, 0}), values = file.view(bytes);
    accessor["sparse"] = {{"count", base ? 1 : 3},
                          {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                          {"values", {{"bufferView", values}}}};
    if (!base) accessor.erase("bufferView");
    const Scene scene = file.load();
    EXPECT_EQ(placed(scene, corners(only_mesh(scene)).at(0)), glm::vec3(0, 0, 7));
    EXPECT_EQ(placed(scene, corners(only_mesh(scene)).at(1)), base ? glm::vec3(1, 0, 0) : glm::vec3(4, 0, 7));
  }
}

TEST(GltfGeometry, NormalisedAndQuantisedIntegers) {
  GltfFile file;
  file.doc["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.doc["extensionsUsed"] = {"KHR_mesh_quantization"};
  const auto padded = [&](const Bytes& bytes, int component, const char* type, bool normalised) {
    return file.accessor(file.view(bytes, 4), 0, component, type, 3, normalised);
  };
  const int position = padded({0, 0, 0, 0, 100, 0, 0, 0, 0, 0x9c, 0, 0}, 5120, "VEC3", false);  // 0x9c = -100
  const int normal = padded({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 0x80, 0}, 5120, "VEC3", true);
  const int uv = padded({0, 0, 0, 0, 255, 0, 0, 0, 51, 255, 0, 0}, 5121, "VEC2", true);
  const int uv1 = file.numbers<uint16_t>({0, 0, 65535, 0, 0, 32768}, "VEC2", true);
  const int colour = padded({255, 0, 51, 0, 0, 0, 0, 0, 0, 255, 0, 0}, 5121, "VEC3", true);
  file.place(
      {{"attributes",
        {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}, {"TEXCOORD_1", uv1}, {"COLOR_0", colour}}}});
  const Scene scene = file.load();
  const std::vector<Vertex>& v = only_mesh(scene).vertices;
  EXPECT_EQ(v[1].position, glm::vec3(100, 0, 0));
  EXPECT_EQ(v[2].position, glm::vec3(0, -100, 0));
  EXPECT_EQ(v[2].normal, glm::vec3(0, 0, -1));  // -128 means -1
  EXPECT_EQ(v[2].uv, glm::vec2(.2f, 1));
  EXPECT_NEAR(v[2].uv1.y, 32768 / 65535., 1e-7);
  EXPECT_EQ(v[0].colour, glm::vec4(1, 0, .2f, 1));
}

TEST(GltfGeometry, ColoursOfFourKinds) {
  GltfFile file = triangle_file();
  json& attributes = file.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["COLOR_0"] = file.numbers<uint16_t>({65535, 0, 0, 13107, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", true);
  EXPECT_EQ(only_mesh(file.load()).vertices[0].colour, glm::vec4(1, 0, 0, .2f));
  attributes["COLOR_0"] = file.numbers<float>({.25f, 2, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  EXPECT_EQ(only_mesh(file.load()).vertices[0].colour, glm::vec4(.25f, 2, 0, 1));
}

TEST(GltfGeometry, NotFiniteAndFlatTrianglesAreLeftOut) {
  GltfFile file;
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  file.place(position_only(file.numbers<float>(
      {0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, inf, 0, 0, 0, 1, 0, 3, 3, 3, 3, 3, 3, 4, 4, 4},
      "VEC3")));
  const Scene scene = file.load();
  EXPECT_EQ(only_mesh(scene).indices.size(), 3u);
  EXPECT_EQ(scene.bounds.max, glm::dvec3(1, 1, 0));
  EXPECT_TRUE(has_warning(scene, "2 triangles with positions that are no usable numbers"));
}

TEST(GltfGeometry, ZeroNormalsAreMendedAndTinyTrianglesKeepTheirs) {
  GltfFile file;
  const int position = file.numbers<float>({0, 0, 0, 1e-15f, 0, 0, 0, 1e-15f, 0}, "VEC3");
  const int normal = file.numbers<float>({0, 0, 0, 0, 0, 3, 0, 0, 1}, "VEC3");
  file.place({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}});
  file.place(position_only(position));
  const Scene scene = file.load();
  ASSERT_EQ(scene.meshes.size(), 2u);
  for (const Mesh& mesh : scene.meshes)
    for (const Vertex& v : mesh.vertices) EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
  EXPECT_TRUE(has_warning(scene, "1 normals without a direction"));
}

}  // namespace
}  // namespace gbl::test
