// The metered exposure: what the lights do on the visible surfaces decides, and nothing else does.
#include "renderer/opening/exposure_meter.h"

#include <gtest/gtest.h>

#include "renderer/opening/scene_look.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

// A wall of 4 x 3 seen from 5 in front of it, and a level floor of any size below.
Scene wall_and_floor(float floor_half_width, const Light& lamp) {
  Scene s = make_plane(floor_half_width, {.base_colour = {0.5f, 0.5f, 0.5f, 1}, .roughness = 1});
  Mesh wall{"wall", {}, {0, 1, 2, 2, 1, 3}};
  for (const float y : {-1.5f, 1.5f})
    for (const float x : {-2.0f, 2.0f}) {
      wall.vertices.push_back(corner({x, y, 0}));
      wall.vertices.back().normal = {0, 0, 1};
    }
  s.meshes.push_back(wall);
  s.instances[0].world_from_object[3] = {0, -1.5, 0, 1};
  s.instances.push_back({"wall", 1, 0, glm::dmat4(1)});
  s.instances[1].world_from_object[3] = {0, 0, -2, 1};
  s.lights = {lamp};
  s.bounds = bounds_of(s);
  return s;
}

Light lamp(double candela) {
  Light l = point_light({0, 0, 0}, kEndless, glm::dvec3(candela));
  l.ends_faint = true;
  return l;
}

Settings seen_from_the_front() {
  Settings s = closed_settings({160, 90});
  s.attenuation = Attenuation::gltf;
  s.camera.position = {0, 0, 3};
  s.camera.orientation = orientation_from_yaw_pitch(0, 0);
  return s;
}

TEST(ExposureMeter, ALargerFloorChangesNothing) {
  const Settings s = seen_from_the_front();
  const std::optional<double> small = metered_exposure(s, wall_and_floor(2, lamp(40)));
  ASSERT_TRUE(small);
  for (const float width : {25.0f, 250.0f, 5000.0f})
    EXPECT_EQ(metered_exposure(s, wall_and_floor(width, lamp(40))), small);
}

// A hundred times the light is a hundredth of the exposure, to a third of a stop.
TEST(ExposureMeter, FollowsTheLightOverElevenDecades) {
  const Settings s = seen_from_the_front();
  const double at_one = metered_exposure(s, wall_and_floor(4, lamp(1))).value();
  for (const double candela : {1e-4, 1e-2, 1e2, 1e4, 1e5})
    EXPECT_NEAR(std::log2(metered_exposure(s, wall_and_floor(4, lamp(candela))).value() * candela / at_one), 0, 0.34);
}

TEST(ExposureMeter, ShowsASunlitWallBelowWhite) {
  for (const double lux : {0.01, 1.0, 100000.0}) {
    Light sun;
    sun.kind = LightKind::directional, sun.direction = {0, 0, -1}, sun.colour = glm::dvec3(lux);
    const double exposure = metered_exposure(seen_from_the_front(), wall_and_floor(4, sun)).value();
    const double shown = 0.5 * lux * exposure;  // Lambert, facing the light
    EXPECT_GT(shown, 0.7 / std::exp2(1.0 / 6) * 0.999) << lux;
    EXPECT_LT(shown, 0.7 * std::exp2(1.0 / 6) * 1.001) << lux;
  }
}

TEST(ExposureMeter, IsAThirdOfAStop) {
  const double stops = 3 * std::log2(metered_exposure(seen_from_the_front(), wall_and_floor(4, lamp(7))).value());
  EXPECT_NEAR(stops, std::round(stops), 1e-9);
}

TEST(ExposureMeter, AmbientAndBackdropKeepTheirShareOfTheDisplay) {
  Settings s = seen_from_the_front();
  s.ambient = 0.2, s.background.colour = glm::dvec3(0.03), s.exposure = 1;
  ASSERT_TRUE(meter(s, wall_and_floor(4, lamp(3e4))));
  EXPECT_LT(s.exposure, 1e-3);
  EXPECT_NEAR(s.ambient * s.exposure, 0.2, 1e-12);
  EXPECT_NEAR(s.background.colour.y * s.exposure, 0.03, 1e-12);
}

TEST(ExposureMeter, WhereNoLightArrivesNothingChanges) {
  Settings s = seen_from_the_front();
  const Settings before = s;
  Light behind = lamp(40);
  behind.position = {0, 0, -500};
  behind.range = 1, behind.ends_faint = false;
  EXPECT_FALSE(meter(s, wall_and_floor(4, behind)));
  EXPECT_EQ(s, before);
}

// Surfaces that shine by themselves, or that no light can change, are not what is metered.
TEST(ExposureMeter, LooksPastWhatIsUnlit) {
  Scene scene = wall_and_floor(4, lamp(40));
  const double exposure = metered_exposure(seen_from_the_front(), scene).value();
  scene.materials.push_back({.base_colour = {1, 1, 1, 1}, .unlit = true});
  scene.instances[0].material = 1;  // the floor
  EXPECT_NEAR(std::log2(metered_exposure(seen_from_the_front(), scene).value() / exposure), 0, 0.7);
}

}  // namespace
}  // namespace gbl::test
