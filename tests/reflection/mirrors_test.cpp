// Which objects mirror, and the cameras that see what they show.
#include "renderer/reflection/mirrors.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/scenes/builtin_scenes.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

Camera some_camera() {
  Camera c;
  c.position = {3, 4, 25};
  c.orientation = orientation_from_yaw_pitch(10, -15);
  c.near = 0.5, c.far = 200;
  return c;
}

// In -1..1 across the picture.
glm::dvec3 on_picture(const Camera& c, const glm::dvec3& world, double aspect) {
  const glm::dvec4 clip = clip_from_relative(c, aspect) * glm::dvec4(world - c.position, 1);
  return glm::dvec3(clip) / clip.w;
}

TEST(Mirrors, TheMirroredCameraSeesAPointWhereThisOneSeesItsImage) {
  Pcg32 random(5);
  const auto unit = [&] { return glm::normalize(glm::dvec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1))); };
  for (const double height : {0.0, 30.0}) {
    Camera c = some_camera();
    c.orthographic_height = height;
    for (int i = 0; i < 200; ++i) {
      const Plane plane{unit(), random.in(-5, 5)};
      const Camera m = mirrored(c, plane);
      const glm::dvec3 p(random.in(-20, 20), random.in(-20, 20), random.in(-20, 20));
      const glm::dvec3 image = p - 2 * plane.distance(p) * plane.normal;
      const glm::dvec3 seen = on_picture(m, p, 1.5), expected = on_picture(c, image, 1.5);
      // Beside the picture the division makes large numbers of rounding errors.
      if (std::abs(expected.x) > 10 || std::abs(expected.y) > 10 || std::abs(expected.z) > 10) continue;
      EXPECT_NEAR(seen.x, -expected.x, 1e-9);
      EXPECT_NEAR(seen.y, expected.y, 1e-9);
      EXPECT_NEAR(seen.z, expected.z, 1e-9);
      EXPECT_NEAR(glm::length(m.orientation), 1, 1e-12) << "a rotation: no winding is flipped";
    }
  }
}

TEST(Mirrors, SixSidesHoldEveryDirectionWithATexelToSpare) {
  for (const int texels : {64, 256}) {
    Camera like = some_camera();
    Pcg32 random(6);
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 d(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
      int holding = 0;
      for (int side = 0; side < 6; ++side) {
        const Camera c = side_camera({.centre = {1, 2, 3}}, side, texels, like);
        const glm::dvec3 at = on_picture(c, c.position + 10.0 * d, 1);
        const bool before = glm::dot(d, c.forward()) > 0;
        holding += before && std::max(std::abs(at.x), std::abs(at.y)) <= 1 - 2.0 / texels + 1e-9;
      }
      EXPECT_GE(holding, 1);
    }
  }
}

TEST(Mirrors, AreFlatWhereOnePlaneHoldsThem) {
  Scene s = make_plane(2, Material{.name = "mirror", .roughness = 0.05f, .metal = 1});
  s.instances[0].world_from_object = glm::rotate(glm::translate(glm::dmat4(1), {1, 2, 3}), 0.5, {0, 0, 1});
  std::vector<Mirror> all = mirrors_of(s);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].object, 1);
  EXPECT_TRUE(all[0].flat);
  EXPECT_NEAR(all[0].plane.distance({1, 2, 3}), 0, 1e-12);
  EXPECT_NEAR(all[0].plane.normal.x, -std::sin(0.5), 1e-12);
  s.meshes[0].vertices[3].position.y += 0.01f;
  EXPECT_FALSE(mirrors_of(s)[0].flat) << "a corner is bent up";
  s.meshes[0].vertices[3].position.y = 0;
  s.meshes[0].vertices[3].normal = glm::normalize(glm::vec3(0.1f, 1, 0));
  EXPECT_FALSE(mirrors_of(s)[0].flat) << "its normals are a dent's";
  s.materials[0].roughness = 0.21f;
  EXPECT_TRUE(mirrors_of(s).empty()) << "too rough for a sharp image";
}

// Parallel rays see a plane's front by its direction, wherever the camera stands; a sheet with two sides shows the nearer.
TEST(Mirrors, FaceACameraOrTurnTheirOtherSide) {
  Camera c;
  c.position = {0, 5, 0};
  c.orientation = orientation_from_yaw_pitch(0, -90);
  const Plane up{{0, 1, 0}, 0}, slanted{glm::normalize(glm::dvec3(1, 1, 0)), 10};
  EXPECT_TRUE(faces(up, c));
  EXPECT_FALSE(faces(slanted, c)) << "the camera is behind it";
  c.orthographic_height = 4;
  EXPECT_TRUE(faces(slanted, c)) << "its rays come from above";
  EXPECT_EQ(facing({{0, -1, 0}, 1}, c).normal, glm::dvec3(0, 1, 0));
  EXPECT_EQ(facing({{0, -1, 0}, 1}, c).offset, -1);
}

// Near its middle, where a small object's neighbours are, a cube sees what the view's near plane would cut.
TEST(Mirrors, SeeWhatIsCloserThanTheViewsNearPlane) {
  Camera like;
  like.near = 1, like.far = 100;
  EXPECT_EQ(side_camera({.centre = {}, .radius = 0.2}, 0, 64, like).near, 0.1);
  EXPECT_EQ(side_camera({.centre = {}, .radius = 9}, 0, 64, like).near, 1);
}

TEST(Mirrors, ClearMaterialsAreStoredWhereTheyRefract) {
  Material glass{.roughness = 0.05f, .alpha_mode = AlphaMode::blend, .transmission = 1};
  EXPECT_TRUE(blends(glass, false));
  EXPECT_FALSE(blends(glass, true));
  glass.roughness = 0.5f;
  EXPECT_TRUE(blends(glass, true)) << "frosted: no sharp image comes through, it stays what it was";
  glass.transmission = 0, glass.roughness = 0.05f;
  EXPECT_TRUE(blends(glass, true));
}

TEST(Mirrors, OfTheRoomAreTheMirrorTheBallsAndTheVases) {
  const Scene room = build_room();
  std::vector<std::string> names;
  for (const Mirror& m : mirrors_of(room)) names.push_back(room.instances[static_cast<size_t>(m.object - 1)].name);
  EXPECT_EQ(names, (std::vector<std::string>{"mirror", "glass ball", "chrome ball", "vase", "floor vase"}));
  EXPECT_TRUE(mirrors_of(room)[0].flat);
  EXPECT_FALSE(mirrors_of(room)[1].flat);
}

}  // namespace
}  // namespace gbl::test
