// Which triangle a pixel sees: on the CPU against rays, and what is made of a driver's word.
#include "renderer/truth/visible_triangles.h"

#include "renderer/base/error.h"
#include "renderer/scenes/mesh_builder.h"
#include "tests/random_view.h"
#include "tests/test_support.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

// Balls and a floor that reaches behind the camera; both sides are seen, as rays see them.
Scene crowd() {
  Scene s = make_plane(30);
  s.materials[0].double_sided = true;
  s.meshes.push_back(make_ellipsoid({1, 1.5, 1}, 16, 8));
  for (int k = 0; k < 12; ++k) {
    glm::dmat4 placed = glm::dmat4(k % 3 == 0 ? -1 : 1);
    placed[3] = glm::dvec4((k % 4) * 3 - 4, 1 + k % 2, (k / 4) * 3 - 3, 1);
    s.instances.push_back({"ball", 1, 0, placed});
  }
  s.bounds = bounds_of(s);
  return s;
}

size_t differing(const std::vector<SeenTexel>& a, const std::vector<SeenTexel>& b) {
  size_t n = 0;
  for (size_t i = 0; i < a.size(); ++i)
    n += a[i].instance() != b[i].instance() || (a[i].instance() >= 0 && a[i].triangle() != b[i].triangle());
  return n;
}

TEST(VisibleTriangles, AreThoseThatRaysMeet) {
  const Scene scene = crowd();
  for (const double orthographic_height : {0.0, 9.0})
    for (const double yaw : {0.0, 40.0, 160.0}) {
      Settings s = closed_settings({61, 37});
      s.camera.position = {1, 2.5, 7};
      s.camera.orientation = orientation_from_yaw_pitch(yaw, -25);
      s.camera.orthographic_height = orthographic_height;
      s.camera.near = 1e-9;  // rays know no near plane
      const std::vector<SeenTexel> found = visible_triangles(s, scene, false), by_rays = seen_by_rays(scene, s);
      EXPECT_EQ(differing(found, by_rays), 0u) << yaw << " " << orthographic_height;
    }
}

TEST(VisibleTriangles, OneSidedSurfacesAreSeenFromTheirFront) {
  Scene scene = make_plane(20);
  Settings s = closed_settings();
  const auto seen = [&] {
    size_t n = 0;
    for (const SeenTexel& t : visible_triangles(s, scene)) n += t.instance() >= 0;
    return n;
  };
  EXPECT_GT(seen(), 300u);
  scene.instances[0].world_from_object = glm::dmat4(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));  // a mirror keeps the side
  EXPECT_GT(seen(), 300u);
  s.camera.position.y = -6;
  s.camera.orientation = orientation_from_yaw_pitch(8, 40);
  EXPECT_EQ(seen(), 0u);
  scene.materials[0].double_sided = true;
  EXPECT_GT(seen(), 300u);
}

// A driver that names any triangle of the ball but the right one, in every pixel.
TEST(CheckTriangles, WhatADriverGetsWrongIsLookedUp) {
  const Scene scene = crowd();
  const Settings s = closed_settings({61, 37});
  const std::vector<SeenTexel> right = seen_by_rays(scene, s);
  std::vector<SeenTexel> named = right;
  EXPECT_EQ(check_triangles(s, scene, named), 0u) << "a right driver is believed";
  size_t spoilt = 0;
  for (SeenTexel& t : named)
    if (t.instance() > 0) {
      t.seen.y = static_cast<float>((t.triangle() + 37) % 256), t.seen.z = 0.25f;
      ++spoilt;
    }
  ASSERT_GT(spoilt, 100u);
  EXPECT_GE(check_triangles(s, scene, named), spoilt * 9 / 10) << "a neighbour at a border may be right by chance";
  EXPECT_LE(differing(named, right), spoilt / 50);
  for (const SeenTexel& t : named)
    EXPECT_EQ(t.seen.z, t.instance() > 0 ? 0.25f : t.instance() == 0 ? 1 : 0) << "texels stay";
}

TEST(CheckTriangles, ATriangleBehindTheOneThatIsSeenIsNotBelieved) {
  Scene scene = make_plane(20);
  scene.materials[0].double_sided = true;
  scene.instances.push_back(scene.instances[0]);
  scene.instances[1].world_from_object[3].y = -3;
  const Settings s = closed_settings();
  std::vector<SeenTexel> named = seen_by_rays(scene, s);
  const std::vector<SeenTexel> right = named;
  for (SeenTexel& t : named)
    if (t.instance() == 0) t.seen.x = 2;  // the floor below
  EXPECT_GT(check_triangles(s, scene, named), 300u);
  EXPECT_LE(differing(named, right), 30u) << "but along the diagonal, where the nearest may have been missed";
}

// A hundredth of a pixel beside the edge of a floor that reaches behind the eye: a rasteriser may show it there.
TEST(CheckTriangles, ATriangleThatReachesBehindTheEyeIsBelievedAtItsEdge) {
  Scene scene = make_plane(20);
  Settings s = closed_settings();
  s.camera.position = {0, 1, 0};
  s.camera.orientation = orientation_from_yaw_pitch(0, 0);
  const glm::ivec2 pixel(24, 12);
  const ViewRays rays = view_rays(s.camera, 32.0 / 18);
  const double x = (2 * (pixel.x + 0.49) / 32 - 1) * rays.right.x, y = (1 - 2 * (pixel.y + 0.5) / 18) * rays.up.y;
  scene.instances[0].world_from_object[0].x = x / -y / 20;  // its right edge runs there
  std::vector<SeenTexel> named = visible_triangles(s, scene, false);
  const size_t i = static_cast<size_t>(pixel.y * s.size.x + pixel.x);
  ASSERT_GE(named[i - 1].instance(), 0);
  ASSERT_LT(named[i].instance(), 0);
  named[i] = named[i - 1];
  EXPECT_EQ(check_triangles(s, scene, named), 0u);
  named[i + 1] = named[i];
  EXPECT_THROW(check_triangles(s, scene, named), Error) << "a pixel farther out";
}

TEST(CheckTriangles, ATriangleOutOfNowhereIsRefusedWithItsPixel) {
  const Scene scene = make_plane(2);
  const Settings s = closed_settings();
  std::vector<SeenTexel> named = seen_by_rays(scene, s);
  ASSERT_LT(named[0].instance(), 0);
  named[0].seen = {1, 1, 1, 1};
  const std::string refused = error_line(ExitCode::unfinished, [&] { check_triangles(s, scene, named); });
  EXPECT_TRUE(contains(refused, "pixel 0, 0")) << refused;
  named[0].seen = {9, 700, 1, 1};  // neither the object nor the triangle exists
  EXPECT_TRUE(contains(error_line(ExitCode::unfinished, [&] { check_triangles(s, scene, named); }), "object 9"));
}

}  // namespace
}  // namespace gbl::test
