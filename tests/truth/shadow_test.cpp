// Shadows of the reference against scenes whose shadows are known in closed form.
#include <gtest/gtest.h>

#include "renderer/scenes/mesh_builder.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

// Calls check(world point, is it lit) for every pixel of the ground, y = 0.
template <class Check>
int each_ground_pixel(const Truth& truth, const Settings& s, double height, Check check) {
  int seen = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    const glm::dvec3 p = truth.position[i] + s.camera.position;
    if (std::abs(p.y) > height) continue;
    ++seen;
    check(p, truth.lit[i].x > 0);
  }
  return seen;
}

// A level square over a larger one. A point light above both: the shadow is a square, scaled by similar triangles.
Scene square_over_ground(double scale) {
  Scene s = make_plane(static_cast<float>(20 * scale));
  Mesh small = make_plane(static_cast<float>(scale)).meshes[0];
  s.meshes.push_back(small);
  glm::dmat4 up(1);
  up[3] = glm::dvec4(0.5 * scale, 2 * scale, -scale, 1);
  s.instances.push_back({"square", 1, 0, up});
  s.bounds = bounds_of(s);
  return s;
}

Settings shadow_settings(double scale) {
  Settings s = closed_settings({96, 54});
  s.shadows = Shadows::all;
  s.camera.position = {scale, 6 * scale, 7 * scale};
  s.camera.near = 0.1 * scale, s.camera.far = 1000 * scale;
  return s;
}

class ShadowScale : public testing::TestWithParam<double> {};

TEST_P(ShadowScale, OfASquareUnderAPointLight) {
  const double k = GetParam();
  Scene scene = square_over_ground(k);
  const glm::dvec3 light(0.2 * k, 5 * k, -0.7 * k), square(0.5 * k, 2 * k, -k);
  scene.lights = {point_light(light)};
  const Settings s = shadow_settings(k);
  const Truth truth = truth_of(scene, s);
  int lit = 0, dark = 0;
  each_ground_pixel(truth, s, 1e-9 * k, [&](const glm::dvec3& p, bool is_lit) {
    const glm::dvec3 on_square = light + (p - light) * ((light.y - square.y) / light.y);
    const double inside = k - std::max(std::abs(on_square.x - square.x), std::abs(on_square.z - square.z));
    if (std::abs(inside) < 1e-9 * k) return;  // on the edge itself
    EXPECT_EQ(is_lit, inside < 0) << p.x << " " << p.z;
    ++(is_lit ? lit : dark);
  });
  EXPECT_GT(lit, 500);
  EXPECT_GT(dark, 100);
}

TEST_P(ShadowScale, OfABoxInTheSun) {
  const double k = GetParam();
  Scene scene = make_plane(static_cast<float>(20 * k));
  scene.meshes.push_back(make_box(glm::dvec3(-1, 0, -1) * k, glm::dvec3(1, 2, 1) * k, 1));
  scene.instances.push_back({"box", 1, 0, glm::dmat4(1)});
  scene.bounds = bounds_of(scene);
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = glm::normalize(glm::dvec3(0.6, -1, -0.3));
  scene.lights = {sun};
  Settings s = shadow_settings(k);
  s.shadows = Shadows::sun;
  const Truth truth = truth_of(scene, s);
  int lit = 0, dark = 0;
  each_ground_pixel(truth, s, 1e-9 * k, [&](const glm::dvec3& p, bool is_lit) {
    // Towards the sun the point meets the box where all three intervals of t overlap.
    const glm::dvec3 to_sun = -sun.direction, low = glm::dvec3(-1, 0, -1) * k, high = glm::dvec3(1, 2, 1) * k;
    double from = 0, to = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (low[axis] - p[axis]) / to_sun[axis], b = (high[axis] - p[axis]) / to_sun[axis];
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    if (std::abs(to - from) < 1e-9 * k) return;
    EXPECT_EQ(is_lit, from > to) << p.x << " " << p.z;
    ++(is_lit ? lit : dark);
  });
  EXPECT_GT(lit, 500);
  EXPECT_GT(dark, 50);
}

// What hides acne must not hide a shadow: a sheet a millionth of the scene's size above the ground still casts one.
TEST_P(ShadowScale, NoSurfaceHidesItselfAndATouchingSheetStillHides) {
  const double k = GetParam();
  Scene scene;
  scene.materials = {{.name = "white"}};
  scene.meshes = {make_ellipsoid(glm::dvec3(3 * k), 64, 32)};
  scene.instances = {{"ball", 0, 0, glm::dmat4(1)}};
  scene.bounds = bounds_of(scene);
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = glm::normalize(glm::dvec3(-1, -0.2, -0.5));
  scene.lights = {sun};
  Settings s = shadow_settings(k);
  const Truth shadowed = truth_of(scene, s);
  s.shadows = Shadows::off;
  const Truth plain = truth_of(scene, s);
  int both = 0;
  for (size_t i = 0; i < plain.pixels(); ++i) {
    if (!plain.present[i] || !(plain.lit[i].x > 0.2)) continue;  // away from where the triangles turn from the sun
    EXPECT_EQ(shadowed.lit[i], plain.lit[i]) << "pixel " << i;
    ++both;
  }
  EXPECT_GT(both, 100);

  Scene sheet = make_plane(static_cast<float>(20 * k));
  Mesh small = make_plane(static_cast<float>(k)).meshes[0];
  sheet.meshes.push_back(small);
  glm::dmat4 up(1);
  up[3].y = 1e-6 * k;
  sheet.instances.push_back({"sheet", 1, 0, up});
  sheet.bounds = bounds_of(sheet);
  const RayScene rays(sheet);
  const glm::dvec3 place(0.3 * k, 0, 0.2 * k);
  EXPECT_LT(rays.least_distance(place), 1e-7 * k);
  EXPECT_TRUE(rays.blocked({place, {0, 1, 0}, rays.least_distance(place), k}, {1, 0}));
  EXPECT_FALSE(rays.blocked({{5 * k, 0, 0}, {0, 1, 0}, rays.least_distance(place), k}, {}));
}

INSTANTIATE_TEST_SUITE_P(From1e_3To1e6, ShadowScale, testing::Values(1e-3, 1, 1e3, 1e6));

TEST(Shadows, OnlyThoseLightsThatAreAskedFor) {
  Scene scene = square_over_ground(1);
  scene.lights = {point_light({0.2, 5, -0.7})};
  Settings s = shadow_settings(1);
  s.shadows = Shadows::off;
  const Truth off = truth_of(scene, s);
  EXPECT_TRUE(off.unshadowed.empty());
  s.shadows = Shadows::sun;
  const Truth sun = truth_of(scene, s);
  EXPECT_EQ(off.lit, sun.lit) << "a point light is no sun";
  s.shadows = Shadows::all;
  const Truth all = truth_of(scene, s);
  EXPECT_NE(off.lit, all.lit);
  for (size_t i = 0; i < all.pixels(); ++i) EXPECT_EQ(all.unshadowed[i], off.light(i)) << i;
}

TEST(Shadows, ALightReachesWhatLiesBetweenItAndTheObstacle) {
  Scene scene = square_over_ground(1);
  scene.lights = {point_light({0.5, 1, -1})};  // below the square
  const Settings s = shadow_settings(1);
  const int dark =
      each_ground_pixel(truth_of(scene, s), s, 1e-9, [](const glm::dvec3&, bool is_lit) { EXPECT_TRUE(is_lit); });
  EXPECT_GT(dark, 500);
}

}  // namespace
}  // namespace gbl::test
