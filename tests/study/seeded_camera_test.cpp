#include "renderer/study/seeded_camera.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/truth/scene_rays.h"

namespace gbl {
namespace {

void expect_sane(const Camera& c, const std::string& what) {
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(c.position[i])) << what;
  EXPECT_NEAR(glm::length(c.orientation), 1, 1e-12) << what;
}

// One square of side 2 about the origin that faces +Z.
Scene square() {
  Scene scene;
  Mesh mesh;
  for (const glm::vec3 p : {glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(1, 1, 0), glm::vec3(-1, 1, 0)}) {
    Vertex v{};
    v.position = p;
    mesh.vertices.push_back(v);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  scene.meshes.push_back(mesh);
  scene.materials.emplace_back();
  scene.instances.push_back({"square", 0, 0, glm::dmat4(1)});
  scene.bounds = bounds_of(scene);
  scene.camera.position = {0, 0, 3};
  scene.camera.near = 0.1;
  return scene;
}

TEST(SceneRays, MeetTheNearestAndTellItsSide) {
  Scene scene = square();
  const auto front = first_hit(scene, {0.2, 0.3, 3}, {0, 0, -1});
  ASSERT_TRUE(front);
  EXPECT_DOUBLE_EQ(front->distance, 3);
  EXPECT_FALSE(front->from_behind);
  EXPECT_TRUE(first_hit(scene, {0.2, 0.3, -3}, {0, 0, 1})->from_behind);
  EXPECT_FALSE(first_hit(scene, {1.2, 0.3, 3}, {0, 0, -1}));
  EXPECT_FALSE(first_hit(scene, {0, 0, 3}, {0, 0, 1})) << "behind the ray's beginning";
  scene.instances[0].world_from_object[0][0] = -1;
  EXPECT_TRUE(first_hit(scene, {0.2, 0.3, 3}, {0, 0, -1})->from_behind) << "mirrored";
  scene.materials[0].double_sided = true;
  EXPECT_FALSE(first_hit(scene, {0.2, 0.3, 3}, {0, 0, -1})->from_behind);
  scene.materials[0].alpha_mode = AlphaMode::blend;
  EXPECT_FALSE(first_hit(scene, {0.2, 0.3, 3}, {0, 0, -1})) << "hides nothing";
}

TEST(SeededCamera, NoughtIsTheOwnOneAndOthersAreTheSameEveryTime) {
  const Scene scene = square();
  EXPECT_EQ(seeded_camera(scene, scene.camera, 0), scene.camera);
  EXPECT_EQ(seeded_camera(scene, scene.camera, 1), seeded_camera(scene, scene.camera, 1));
  EXPECT_NE(seeded_camera(scene, scene.camera, 1), seeded_camera(scene, scene.camera, 2));
}

TEST(SeededCamera, KeepsTheLensAndLooksAtThePoint) {
  Scene scene = square();
  scene.camera.fov = 60;
  for (int k = 1; k <= 50; ++k) {
    const Camera c = seeded_camera(scene, scene.camera, k);
    EXPECT_EQ(c.fov, 60);
    EXPECT_EQ(c.near, scene.camera.near);
    EXPECT_EQ(c.far, scene.camera.far);
    const double distance = glm::length(c.position);  // the point is the origin
    EXPECT_GE(distance, 0.6 * 3 - 1e-9);
    EXPECT_LE(distance, 1.4 * 3 + 1e-9);
    EXPECT_NEAR(glm::dot(c.forward(), -c.position / distance), 1, 1e-12);
  }
}

TEST(SeededCamera, SeesSomethingInEveryBuiltinScene) {
  for (const BuiltinScene& row : builtin_scenes()) {
    const Scene scene = row.build();
    int own = 0;
    for (int k = 1; k <= 4; ++k) {
      const Camera c = seeded_camera(scene, scene.camera, k);
      expect_sane(c, row.id);
      own += c == scene.camera;
      const auto hit = first_hit(scene, c.position, c.forward());
      EXPECT_FALSE(hit && hit->from_behind) << row.id << " " << k;
    }
    EXPECT_EQ(own, 0) << row.id << ": no good place was found";
  }
}

TEST(SeededCamera, StaysIndoors) {
  const Scene hall = build_hall();
  for (int k = 1; k <= 4; ++k) {
    const glm::dvec3 p = seeded_camera(hall, hall.camera, k).position;
    EXPECT_TRUE(glm::all(glm::greaterThan(p, hall.bounds.min)) && glm::all(glm::lessThan(p, hall.bounds.max))) << k;
  }
}

TEST(SeededCamera, IsFiniteInOddScenes) {
  Scene scene;  // nothing in it
  EXPECT_EQ(seeded_camera(scene, scene.camera, 3), scene.camera);
  scene = square();
  scene.camera.position = {0, 0, -50};  // the scene is behind
  expect_sane(seeded_camera(scene, scene.camera, 1), "behind");
  scene.instances[0].world_from_object = glm::dmat4(1e300);
  scene.bounds = {glm::dvec3(-1e300), glm::dvec3(1e300)};
  expect_sane(seeded_camera(scene, scene.camera, 1), "huge");
  scene.bounds.max = glm::dvec3(std::numeric_limits<double>::infinity());
  expect_sane(seeded_camera(scene, scene.camera, 1), "endless");
  scene.bounds.max = glm::dvec3(std::nan(""));
  expect_sane(seeded_camera(scene, scene.camera, 1), "not a number");
  scene = square();
  scene.camera.orientation = orientation_from_yaw_pitch(0, -90);
  scene.camera.position = {0, 5, 0};
  expect_sane(seeded_camera(scene, scene.camera, 1), "straight down");
}

}  // namespace
}  // namespace gbl
