#include <cmath>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {
namespace {

glm::dvec3 at(const Scene& scene, size_t instance, glm::dvec3 p) {
  return glm::dvec3(scene.instances.at(instance).world_from_object * glm::dvec4(p, 1));
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(GltfScene, HierarchyInDoubleWithMatrixAndTrs) {
  GltfFile file = triangle_file();
  const double s = std::sqrt(.5);
  file.node(0).update({{"translation", {1e7, 0, 0.25}}, {"rotation", {0, 0, s, s}}, {"scale", {2, 3, -4}}});
  const int parent = file.add("nodes", {{"children", {0}}});
  file.node(parent)["matrix"] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 5, 0, 1};
  file.doc["scenes"][0]["nodes"] = {parent};
  const Scene scene = file.load();
  // scale, then a quarter about z, then the translation, then the parent: x' = z, y' = y + 5, z' = -x.
  expect_near(at(scene, 0, {1, 1, 1}), {.25 - 4, 2 + 5, -(1e7 - 3)});
  EXPECT_LT(glm::determinant(glm::dmat3(scene.instances[0].world_from_object)), 0);
}

TEST(GltfScene, MeshesAreSharedAndPrimitivesAreInstances) {
  GltfFile file = triangle_file();
  json& primitives = file.doc["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  for (int i = 0; i < 3; ++i)
    file.doc["scenes"][0]["nodes"].push_back(
        file.add("nodes", {{"mesh", 0}, {"translation", {i, 0, 0}}, {"name", "copy"}}));
  const Scene scene = file.load();
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.instances.size(), 8u);
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.instances[7].name, "copy");
  EXPECT_EQ(scene.instances[7].mesh, 1);
}

TEST(GltfScene, WhichSceneIsShown) {
  GltfFile file = triangle_file();
  const int far = file.add("nodes", {{"mesh", 0}, {"translation", {9, 0, 0}}});
  file.add("scenes", {{"nodes", {far}}});
  EXPECT_EQ(file.load().bounds.min.x, 0);
  file.doc["scene"] = 1;
  EXPECT_EQ(file.load().bounds.min.x, 9);
  file.doc["scene"] = 7;
  EXPECT_TRUE(has_warning(file.load(), "'scene' is none of the 2 scenes"));
  file.doc.erase("scenes");
  file.doc.erase("scene");
  EXPECT_EQ(file.load().instances.size(), 2u);  // all roots
}

TEST(GltfScene, CyclesSecondParentsAndBombsAreTakenOnce) {
  GltfFile file = triangle_file();
  file.node(0)["children"] = {0};
  EXPECT_TRUE(has_warning(file.load(), "hangs in two places or in a circle"));
  // 60 generations, each node a child of both before it: 2^60 paths.
  GltfFile bomb = triangle_file();
  for (int i = 1; i < 120; ++i) bomb.add("nodes", {{"mesh", 0}});
  for (int i = 0; i + 3 < 120; i += 2) bomb.node(i)["children"] = bomb.node(i + 1)["children"] = {i + 2, i + 3};
  bomb.doc["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(bomb.load().instances.size(), 120u);
}

TEST(GltfScene, PerspectiveAndOrthographicCameras) {
  GltfFile file = triangle_file();
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", .5}, {"znear", .25}, {"zfar", 50}}}});
  const int eye =
      file.add("nodes", {{"camera", 0}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}, {"rotation", {0, 1, 0, 0}}});
  file.doc["scenes"][0]["nodes"].push_back(eye);
  Camera camera = file.load().camera;
  EXPECT_NEAR(camera.fov, glm::degrees(.5), 1e-12);
  EXPECT_EQ(camera.near, .25);
  EXPECT_EQ(camera.far, 50);
  expect_near(camera.position, {1, 2, 3});
  expect_near(camera.forward(), {0, 0, 1});
  EXPECT_EQ(camera.aspect, 0) << "none is stated";
  file.doc["cameras"][0]["perspective"]["aspectRatio"] = 4;
  EXPECT_EQ(file.load().camera.aspect, 4);
  file.doc["cameras"][0]["perspective"].erase("zfar");
  EXPECT_EQ(file.load().camera.far, .25 * kGltfFarOfEndlessCamera);
  file.doc["cameras"][0] = {{"type", "orthographic"},
                            {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}};
  camera = file.load().camera;
  EXPECT_EQ(camera.orthographic_height, 4);
  EXPECT_EQ(camera.aspect, 1.5);
  EXPECT_GT(camera.near, 0);
  file.doc["cameras"][0] = {{"type", "perspective"}, {"perspective", {{"yfov", 9}, {"znear", 1}}}};
  EXPECT_TRUE(has_warning(file.load(), "its camera's lens or direction is not usable"));
}

TEST(GltfScene, WithoutACameraTheWholeIsInTheFrame) {
  const Scene scene = triangle_file().load();
  const glm::dmat4 clip = clip_from_view(scene.camera, 1) * glm::mat4_cast(glm::inverse(scene.camera.orientation));
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? scene.bounds.max.x : scene.bounds.min.x, corner & 2 ? scene.bounds.max.y : 0,
                       corner & 4 ? scene.bounds.max.z : 0);
    const glm::dvec4 c = clip * glm::dvec4(p - scene.camera.position, 1);
    for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(c[axis]), c.w);
  }
  EXPECT_GT(scene.camera.position.z, 0);  // from the front: models face +Z
}

// The model touches 80 % of the shorter side, in the middle, in pictures of any shape.
TEST(GltfScene, WithoutACameraTheModelFillsTheFrame) {
  GltfFile wide = triangle_file(), flat = triangle_file(), far_off = triangle_file();
  wide.node(0)["scale"] = {30, 1, 1};
  flat.node(0)["scale"] = {1, 0.01, 1};
  far_off.node(0)["translation"] = {1e5, -2e5, 3e5};
  far_off.node(0)["scale"] = {1e-3, 1e-3, 1e-3};
  for (const Scene& scene : {triangle_file().load(), wide.load(), flat.load(), far_off.load()})
    for (const double aspect : {16.0 / 9, 1.0, 0.5}) {
      const glm::dmat4 clip = clip_from_relative(scene.camera, aspect);
      glm::dvec2 low(INFINITY), high(-INFINITY);
      visit_points(scene, [&](const glm::dvec3& p) {
        const glm::dvec4 c = clip * glm::dvec4(p - scene.camera.position, 1);
        low = glm::min(low, glm::dvec2(c) / c.w), high = glm::max(high, glm::dvec2(c) / c.w);
        EXPECT_LE(std::abs(c.z), c.w);
      });
      const double shorter = std::min(aspect, 1.0);  // of a picture that is 1 high
      const glm::dvec2 share = (high - low) / 2.0 * glm::dvec2(aspect, 1) / shorter;
      EXPECT_NEAR(std::max(share.x, share.y), 0.8, 1e-6) << aspect;
      const int longer = share.x > share.y ? 0 : 1;
      EXPECT_NEAR(low[longer] + high[longer], 0, 1e-6) << "in the middle";
      EXPECT_NEAR(low[1 - longer] + high[1 - longer], 0, 0.3) << "about in the middle: what is nearer is larger";
    }
}

TEST(GltfScene, LightsBelowANodeOfNoSizeStillStandSomewhere) {
  GltfFile file = triangle_file();
  file.doc["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}, {{"type", "spot"}}};
  for (int i = 0; i < 2; ++i) {
    json light = {{"translation", {1, 0, 0}}};
    light["extensions"]["KHR_lights_punctual"]["light"] = i;
    file.add("nodes", light);
  }
  const int parent = file.add("nodes", {{"children", {1, 2}}, {"translation", {3, 4, 5}}});
  file.doc["scenes"][0]["nodes"].push_back(parent);
  const auto lights_at = [&](double x, double y, double z) {
    file.node(parent)["scale"] = {x, y, z};
    const Scene scene = file.load();
    for (const Light& l : scene.lights) {
      EXPECT_NEAR(glm::length(l.direction), 1, 1e-9);
      expect_near(l.position, {3 + x, 4, 5});
    }
    for (size_t i = 1; i < scene.lights.size(); ++i) expect_near(scene.lights[i].direction, {0, 0, -1});
    return scene.lights.size();
  };
  EXPECT_EQ(lights_at(1, 1, 0), 2u) << "x and y still say where z is";
  EXPECT_EQ(lights_at(1, 0, 1), 2u);
  EXPECT_EQ(lights_at(0, 0, 1), 2u);
  EXPECT_EQ(lights_at(1e-200, 1e-200, 1e-200), 2u);
  EXPECT_EQ(lights_at(0, 0, 0), 1u) << "a spot light that looks nowhere is left out, a point light needs no direction";
}

TEST(GltfScene, MeshesFarFromTheirOriginKeepTheirDigits) {
  GltfFile file = triangle_file();
  const float o = 1e6f;
  const int place = file.numbers<float>({o, 0, 0, o + 1, 0, 0, o, 1, 0}, "VEC3");
  file.doc["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = place;
  const Scene scene = file.load();
  for (const Vertex& v : scene.meshes[0].vertices) EXPECT_LE(std::abs(v.position.x), 1);
  expect_near(at(scene, 0, glm::dvec3(scene.meshes[0].vertices[1].position)), {o + 1, 0, 0});
  EXPECT_EQ(scene.bounds.min.x, o);
  EXPECT_EQ(triangle_file().load().instances[0].world_from_object, glm::dmat4(1))
      << "near its origin it stays as it is";
}

TEST(GltfScene, PointsAloneLoadWithANote) {
  GltfFile file = triangle_file();
  file.doc["meshes"][0]["primitives"][0]["mode"] = 0;
  const Scene scene = file.load();
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_TRUE(has_warning(scene, "points and lines are not drawn"));
}

TEST(GltfScene, OtherScenesAndSkinsAreSaid) {
  GltfFile file = triangle_file();
  EXPECT_FALSE(has_warning(file.load(), "scenes"));
  file.add("scenes", {{"nodes", json::array()}});
  EXPECT_TRUE(has_warning(file.load(), "it holds 2 scenes: scene 0 is shown"));
  const std::vector<Seed> all = seeds();
  const auto skinned = std::find_if(all.begin(), all.end(), [](const Seed& s) { return s.name == "skinned.glb"; });
  ASSERT_NE(skinned, all.end());
  EXPECT_TRUE(has_warning(load_gltf_from_memory(skinned->bytes, "test"), "rest pose"));
}

TEST(GltfScene, PunctualLights) {
  GltfFile file = triangle_file();
  file.doc["extensionsRequired"] = {"KHR_lights_punctual"};
  file.doc["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"color", {1, .5, 0}}, {"intensity", 40}, {"range", 6}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", .25}, {"outerConeAngle", .5}}}},
      {{"type", "directional"}, {"intensity", 3}},
      {{"type", "area"}},
      {{"type", "spot"}}};
  for (int i = 0; i < 5; ++i) {
    json node = {{"translation", {i, 2, 3}}, {"rotation", {0, 1, 0, 0}}, {"scale", {5, 5, 5}}};
    node["extensions"]["KHR_lights_punctual"]["light"] = i;
    file.doc["scenes"][0]["nodes"].push_back(file.add("nodes", node));
  }
  const Scene scene = file.load();
  ASSERT_EQ(scene.lights.size(), 4u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::point);
  expect_near(scene.lights[0].colour, {40, 20, 0});
  EXPECT_EQ(scene.lights[0].range, 6);
  expect_near(scene.lights[1].position, {1, 2, 3});
  expect_near(scene.lights[1].direction, {0, 0, 1});
  EXPECT_EQ(scene.lights[1].inner_cos, std::cos(.25));
  EXPECT_EQ(scene.lights[1].outer_cos, std::cos(.5));
  EXPECT_EQ(scene.lights[1].range, kEndless);
  expect_near(scene.lights[2].colour, {3, 3, 3});
  EXPECT_NEAR(scene.lights[3].outer_cos, std::sqrt(.5), 1e-9);
  EXPECT_TRUE(has_warning(scene, "its light's kind, colour or direction is not usable"));
}

TEST(GltfScene, SkinnedMeshesStandInTheirRestPose) {
  for (const Seed& seed : seeds()) {
    if (seed.name != "skinned.glb") continue;
    const Scene scene = load_gltf_from_memory(seed.bytes, "test");
    // Joints: root at (0,0,5), second (0,1,5). Corner 2 follows both by half: (0,1,0) + (0,.5,5).
    const glm::dvec3 expected[] = {{0, 0, 5}, {1, 1, 5}, {0, 1.5, 5}};
    for (size_t i = 0; i < 3; ++i)
      expect_near(at(scene, 0, glm::dvec3(scene.meshes.at(0).vertices[i].position)), expected[i]);
    return;
  }
  FAIL() << "no such seed";
}

TEST(GltfScene, WhatIsSkippedIsSaidOnce) {
  GltfFile file = triangle_file();
  json& primitives = file.doc["meshes"][0]["primitives"];
  for (const int mode : {0, 1, 3}) {
    primitives.push_back(primitives[0]);
    primitives.back()["mode"] = mode;
  }
  primitives[0]["targets"] = json::array({{{"POSITION", 0}}});
  file.add("animations", {{"channels", json::array()}, {"samplers", json::array()}});
  file.doc["extensionsUsed"] = {"KHR_materials_clearcoat"};
  const Scene scene = file.load();
  EXPECT_EQ(scene.warnings.size(), 4u);
  for (const char* part : {"points and lines", "morph targets", "animations", "KHR_materials_clearcoat"})
    EXPECT_TRUE(has_warning(scene, part)) << part;
  EXPECT_EQ(scene.instances.size(), 1u);
}

TEST(GltfScene, NamesInAnyEncoding) {
  GltfFile file = triangle_file();
  file.node(0)["name"] = "h\xc3\xa9llo\n\xe2\x82\xac";
  EXPECT_EQ(file.load().instances[0].name, "h\xc3\xa9llo \xe2\x82\xac");
  std::string text = file.gltf();
  text.replace(text.find("\xc3\xa9"), 2, "\xe9");  // Latin-1
  const Scene scene = load_gltf_from_memory(bytes_of(text), "test");
  EXPECT_EQ(scene.instances[0].name, "h\xc3\xa9llo \xe2\x82\xac");
  EXPECT_TRUE(has_warning(scene, "not UTF-8"));
}

TEST(GltfScene, ProgressGrowsAndCancelStops) {
  LoadProgress progress;
  double last = -1;
  progress.report = [&](std::string_view, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  load_gltf_from_memory(textured_file().glb(), "test", &progress);
  EXPECT_EQ(last, 1);
  progress.report = [&](std::string_view stage, double) { progress.cancelled = stage == "meshes"; };
  try {
    load_gltf_from_memory(textured_file().glb(), "test", &progress);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
  }
}

}  // namespace
}  // namespace gbl::test
