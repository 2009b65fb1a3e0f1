#include <gtest/gtest.h>

#include "renderer/gltf/tangents.h"
#include "tests/gltf/gltf_fixture.h"
#include "tests/test_paths.h"

namespace gbl {
namespace {

Vertex vertex(glm::vec3 p, glm::vec2 uv) { return {p, {0, 0, 1}, {0, 0, 0, 0}, uv, uv * 2.f}; }

// A square facing +Z; the picture stands upright on it: u to the right, v downwards.
Mesh square() {
  Mesh mesh;
  mesh.vertices = {vertex({0, 0, 0}, {0, 1}), vertex({1, 0, 0}, {1, 1}), vertex({1, 1, 0}, {1, 0}),
                   vertex({0, 1, 0}, {0, 0})};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

TEST(Tangents, UprightPictureHasTangentRightAndBitangentUp) {
  Mesh mesh = square();
  make_tangents(mesh);
  ASSERT_EQ(mesh.vertices.size(), 4u);
  for (const Vertex& v : mesh.vertices) {
    EXPECT_EQ(v.tangent, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, glm::vec3(0, 1, 0));
  }
}

TEST(Tangents, MirroredPictureKeepsUpAndTurnsTheSign) {
  Mesh mesh = square();
  for (Vertex& v : mesh.vertices) v.uv.x = 1 - v.uv.x;
  make_tangents(mesh);
  for (const Vertex& v : mesh.vertices) EXPECT_EQ(v.tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(Tangents, WhereBothOrientationsMeetTheVertexBecomesTwo) {
  Mesh mesh = square();  // a second square to the left, mirrored about x = 0
  mesh.vertices.push_back(vertex({-1, 0, 0}, {1, 1}));
  mesh.vertices.push_back(vertex({-1, 1, 0}, {1, 0}));
  mesh.indices.insert(mesh.indices.end(), {4, 0, 3, 4, 3, 5});
  make_tangents(mesh);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const Vertex& v = mesh.vertices[mesh.indices[i]];
    EXPECT_EQ(v.tangent, i < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1)) << i;
  }
}

TEST(Tangents, UnsharedVerticesGetTheSharedAnswerWeightedByAngle) {
  // Two triangles about a bent edge; the same with vertices of their own gives the same tangents.
  Mesh shared = square();
  shared.vertices[1].uv = {.8f, 1.3f};
  Mesh own;
  for (const uint32_t i : shared.indices) {
    own.indices.push_back(static_cast<uint32_t>(own.vertices.size()));
    own.vertices.push_back(shared.vertices[i]);
  }
  make_tangents(shared);
  make_tangents(own);
  for (size_t i = 0; i < own.indices.size(); ++i)
    EXPECT_EQ(own.vertices[i].tangent, shared.vertices[shared.indices[i]].tangent) << i;
  // At corner 0 both triangles have 45 degrees: the tangent halves the angle between the faces' own.
  Mesh first = square(), second = square();
  first.vertices[1].uv = second.vertices[1].uv = {.8f, 1.3f};
  first.indices = {0, 1, 2};
  second.indices = {0, 2, 3};
  make_tangents(first);
  make_tangents(second);
  const glm::vec3 mean = glm::normalize(glm::vec3(first.vertices[0].tangent) + glm::vec3(second.vertices[0].tangent));
  EXPECT_NEAR(glm::distance(mean, glm::vec3(shared.vertices[0].tangent)), 0, 1e-6);
}

TEST(Tangents, FollowTheMapsTransformAndUvSet) {
  Mesh mesh = square();
  // u' = v, v' = -u: the picture lies turned by a quarter.
  make_tangents(mesh, 1, glm::mat3(0, -1, 0, 1, 0, 0, 0, 0, 1));
  for (const Vertex& v : mesh.vertices) EXPECT_EQ(v.tangent, glm::vec4(0, -1, 0, 1));
}

TEST(Tangents, WithoutAreaInUvAnyUnitTangent) {
  Mesh mesh = square();
  for (Vertex& v : mesh.vertices) v.uv = {0, 0};
  make_tangents(mesh);
  for (const Vertex& v : mesh.vertices) {
    EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-6);
    EXPECT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0, 1e-6);
  }
}

// Files that bring MikkTSpace's own tangents: ours must be theirs. The renderer never sees the difference.
TEST(Tangents, AgreeWithThoseInModels) {
  const std::filesystem::path models = test::source_folder().parent_path() / "shared/models";
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no folder of test models beside the project";
  for (const char* name : {"FlightHelmet/FlightHelmet.gltf", "WaterBottle/WaterBottle.gltf"}) {
    const Scene scene = load_gltf(models / name);
    size_t corners = 0, near = 0, same_sign = 0;
    for (const Mesh& given : scene.meshes) {
      Mesh made = given;
      make_tangents(made);
      for (size_t i = 0; i < given.indices.size(); ++i) {
        const glm::vec4 a = given.vertices[given.indices[i]].tangent, b = made.vertices[made.indices[i]].tangent;
        ++corners;
        near += glm::dot(glm::vec3(a), glm::vec3(b)) > 0.985;  // 10 degrees
        same_sign += a.w == b.w;
      }
    }
    EXPECT_GT(static_cast<double>(same_sign) / static_cast<double>(corners), .97) << name;
    EXPECT_GT(static_cast<double>(near) / static_cast<double>(corners), .97) << name;
    RecordProperty(name, std::to_string(100. * static_cast<double>(near) / static_cast<double>(corners)));
  }
}

}  // namespace
}  // namespace gbl
