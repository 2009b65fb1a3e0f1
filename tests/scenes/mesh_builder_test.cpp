#include "renderer/scenes/mesh_builder.h"

#include <gtest/gtest.h>

#include "tests/scenes/mesh_promises.h"

namespace gbl {
namespace {

TEST(MeshBuilder, ChecksOfThePromisesCanFail) {
  Mesh box = make_box({0, 0, 0}, {1, 2, 3}, 1);
  ASSERT_EQ(broken_promise(box), "");
  Mesh wrong = box;
  std::swap(wrong.indices[0], wrong.indices[1]);
  EXPECT_EQ(broken_promise(wrong), "triangle not counter-clockwise seen from outside");
  wrong = box;
  wrong.vertices[0].tangent.w = -1;
  EXPECT_EQ(broken_promise(wrong), "bitangent follows v");
}

TEST(MeshBuilder, MirroredTextureGetsTheOtherSign) {
  Mesh box = make_box({0, 0, 0}, {1, 2, 3}, 1);
  for (Vertex& v : box.vertices) v.uv.x = -v.uv.x;
  EXPECT_NE(broken_promise(box), "");
  set_tangents(box);
  EXPECT_EQ(broken_promise(box), "");
  for (const Vertex& v : box.vertices) EXPECT_EQ(v.tangent.w, -1);
}

TEST(MeshBuilder, UnevenScaleKeepsNormalsUpright) {
  const Mesh ball = make_ellipsoid({1, 2, 3}, 16, 12);
  for (const Vertex& v : ball.vertices) {  // the gradient of x^2 + (y/2)^2 + (z/3)^2
    const glm::dvec3 p(v.position), gradient = glm::normalize(p / glm::dvec3(1, 4, 9));
    EXPECT_GT(glm::dot(gradient, glm::dvec3(v.normal)), 0.999);
  }
}

TEST(MeshBuilder, SolidsKeepTheirPromises) {
  const std::vector<glm::dvec2> cup = {{0, 0}, {2, 0}, {3, 5}, {0, 5}};
  EXPECT_EQ(broken_promise(make_lathe(cup, 7)), "");
  EXPECT_EQ(broken_promise(make_ellipsoid({1, 2, 3}, 12, 8)), "");
  EXPECT_EQ(broken_promise(make_boulder({5, 4, 6}, 0.2, 9, 0.1)), "");
}

}  // namespace
}  // namespace gbl
