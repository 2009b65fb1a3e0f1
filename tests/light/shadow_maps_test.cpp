// Where shadow maps look: what must be in a map is in it, and no matrix is none.
#include "renderer/light/shadow_maps.h"

#include <gtest/gtest.h>

#include "renderer/base/random.h"

namespace gbl {
namespace {

const Bounds kScene{{-20, 0, -20}, {20, 10, 20}};
const glm::dvec3 kAnchor(0, 5, 0);  // its middle

Camera camera() {
  Camera c;
  c.position = {3, 4, 25};
  c.orientation = orientation_from_yaw_pitch(10, -15);
  c.near = 0.5, c.far = 200;
  return c;
}

Light light_of(LightKind kind, const glm::dvec3& direction = {0, -1, 0}) {
  Light l;
  l.kind = kind;
  l.position = {1, 6, 2}, l.range = 15;
  l.direction = glm::normalize(direction);
  l.inner_cos = std::cos(0.3), l.outer_cos = std::cos(0.6);
  return l;
}

ShadowPlan plan_of(const std::vector<Light>& lights, const ShadowWishes& wishes = {}) {
  return plan_shadows(lights, camera(), 16.0 / 9, kScene, wishes);
}

glm::dvec3 in_box(Pcg32& random, const Bounds& b) {
  return {random.in(b.min.x, b.max.x), random.in(b.min.y, b.max.y), random.in(b.min.z, b.max.z)};
}

// In -1..1 where the map holds it.
glm::dvec3 on_map(const ShadowMap& m, const glm::dvec3& world) {
  const glm::dvec4 clip = m.clip_from_anchored * glm::dvec4(world - kAnchor, 1);
  return clip.w > 0 ? glm::dvec3(clip) / clip.w : glm::dvec3(2);
}
bool holds(const ShadowMap& m, const glm::dvec3& world) {
  return glm::all(glm::lessThanEqual(glm::abs(on_map(m, world)), glm::dvec3(1)));
}

TEST(ShadowMaps, TheSixFacesOfACubeAreRotationsThatLookAlongTheirAxes) {
  for (int face = 0; face < kCubeFaces; ++face) {
    const glm::dmat3 view = view_of_cube_face(face);
    glm::dvec3 direction(0);
    direction[face / 2] = face % 2 == 0 ? 1 : -1;
    EXPECT_LT(glm::distance(view * direction, glm::dvec3(0, 0, -1)), 1e-12) << face;
    EXPECT_NEAR(glm::determinant(view), 1, 1e-12) << face;
    EXPECT_LT(glm::length((glm::transpose(view) * view)[0] - glm::dvec3(1, 0, 0)), 1e-12) << face;
  }
}

TEST(ShadowMaps, NoDirectionMakesAMatrixOfNoNumbers) {
  for (const LightKind kind : {LightKind::spot, LightKind::directional})
    for (const glm::dvec3& d : {glm::dvec3(0, 1, 0), {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {1e-9, -1, 0}, {1, 1, 1}})
      for (const ShadowMap& m : plan_of({light_of(kind, d)}).maps) EXPECT_TRUE(is_finite(m.clip_from_anchored));
}

TEST(ShadowMaps, APointLightsFacesHoldAllAroundIt) {
  const Light l = light_of(LightKind::point);
  const ShadowPlan plan = plan_of({l});
  ASSERT_EQ(plan.maps.size(), 6u);
  Pcg32 random(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p = in_box(random, {l.position - 8.0, l.position + 8.0}), v = p - l.position, a = glm::abs(v);
    if (std::max({a.x, a.y, a.z}) < 0.1) continue;
    // As shaders/shadow.glsl chooses it.
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    EXPECT_TRUE(holds(plan.maps[static_cast<size_t>(2 * axis + (v[axis] < 0))], p)) << v.x << " " << v.y << " " << v.z;
  }
}

TEST(ShadowMaps, ASpotsMapHoldsItsCone) {
  const Light l = light_of(LightKind::spot, {0.3, -1, 0.2});
  const ShadowPlan plan = plan_of({l});
  ASSERT_EQ(plan.maps.size(), 1u);
  Pcg32 random(2);
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 p = in_box(random, kScene), v = p - l.position;
    const double d = glm::length(v);
    if (d >= l.range || d < 0.1 || glm::dot(v, l.direction) <= l.outer_cos * d) continue;
    EXPECT_TRUE(holds(plan.maps[0], p));
    ++inside;
  }
  EXPECT_GT(inside, 20);
}

class SunMaps : public testing::TestWithParam<bool> {};  // stable
INSTANTIATE_TEST_SUITE_P(BothWays, SunMaps, testing::Bool());

TEST_P(SunMaps, HoldWhatIsSeenAndAllThatMayHideIt) {
  const Light sun = light_of(LightKind::directional, {0.4, -1, -0.3});
  const ShadowPlan plan = plan_of({sun}, {.cascades = 4, .stable = GetParam()});
  ASSERT_EQ(plan.maps.size(), 4u);
  Pcg32 random(3);
  const glm::dmat4 clip_from_camera = clip_from_relative(camera(), 16.0 / 9);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 p = in_box(random, kScene), relative = p - camera().position;
    const glm::dvec4 clip = clip_from_camera * glm::dvec4(relative, 1);
    if (!(clip.w > 0) || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || std::abs(clip.z) > clip.w) continue;
    ++seen;
    const double range = glm::dot(relative, camera().forward());
    size_t k = 0;
    while (k < 3 && range >= plan.maps[k].up_to) ++k;
    EXPECT_TRUE(holds(plan.maps[k], p)) << "cascade " << k;
    const glm::dvec3 hider = p - sun.direction * random.in(0, (kScene.max.y - p.y) / -sun.direction.y);
    if (glm::all(glm::lessThan(glm::abs(hider), glm::dvec3(20)))) {
      EXPECT_TRUE(holds(plan.maps[k], hider));
      EXPECT_LE(on_map(plan.maps[k], hider).z, on_map(plan.maps[k], p).z + 1e-12) << "nearer to the sun";
    }
  }
  EXPECT_GT(seen, 500);
}

// As the camera steps and turns, each map keeps its size and moves by whole texels of a grid that does not move.
TEST(ShadowMaps, StableOnesMoveByWholeTexels) {
  const std::vector<Light> sun = {light_of(LightKind::directional, {0.4, -1, -0.3})};
  const ShadowWishes wishes{.map_texels = 512, .cascades = 3};
  const ShadowPlan before = plan_shadows(sun, camera(), 16.0 / 9, kScene, wishes);
  Pcg32 random(4);
  int moved = 0;
  for (int i = 0; i < 100; ++i) {
    Camera c = camera();
    c.position += glm::dvec3(random.in(-0.1, 0.1), random.in(-0.1, 0.1), random.in(-0.1, 0.1));
    c.orientation = orientation_from_yaw_pitch(random.in(-180, 180), random.in(-60, 60));
    const ShadowPlan after = plan_shadows(sun, c, 16.0 / 9, kScene, wishes);
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(after.maps[k].texel, before.maps[k].texel);
      const glm::dmat4 &m = after.maps[k].clip_from_anchored, &n = before.maps[k].clip_from_anchored;
      for (int axis = 0; axis < 2; ++axis) {
        const double texels = (m[3][axis] - n[3][axis]) * wishes.map_texels / 2;
        EXPECT_NEAR(texels, std::round(texels), 1e-6);
        moved += texels != 0;
      }
    }
  }
  EXPECT_GT(moved, 100) << "they do follow it";
}

// What a lamp's map holds does not depend on the camera: it need not be drawn again.
TEST(ShadowMaps, OfALampAreTheSameForEveryCamera) {
  const std::vector<Light> lamps = {light_of(LightKind::point), light_of(LightKind::spot)};
  Camera elsewhere = camera();
  elsewhere.position = {-7, 9, 1}, elsewhere.orientation = orientation_from_yaw_pitch(70, 20);
  const ShadowPlan a = plan_of(lamps), b = plan_shadows(lamps, elsewhere, 1, kScene, {});
  ASSERT_EQ(a.maps.size(), b.maps.size());
  for (size_t k = 0; k < a.maps.size(); ++k) EXPECT_EQ(a.maps[k].clip_from_anchored, b.maps[k].clip_from_anchored);
}

TEST(ShadowMaps, FromOneUnitOnTheyHoldNothingNearer) {
  const Light lamp = light_of(LightKind::point);
  const ShadowMap down = plan_of({lamp}, {.near_one = true}).maps[3];
  EXPECT_FALSE(holds(down, lamp.position - glm::dvec3(0, 0.99, 0)));
  EXPECT_TRUE(holds(down, lamp.position - glm::dvec3(0, 1.01, 0)));
  EXPECT_TRUE(holds(down, lamp.position - glm::dvec3(0, 1.49 * lamp.range, 0)));
  EXPECT_FALSE(holds(down, lamp.position - glm::dvec3(0, 1.51 * lamp.range, 0)));
}

TEST(ShadowMaps, WithTheSameUpVectorTwoOfSixAreNoNumbers) {
  int finite = 0;
  for (const ShadowMap& m : plan_of({light_of(LightKind::point)}, {.up_is_always_y = true}).maps)
    finite += is_finite(m.clip_from_anchored);
  EXPECT_EQ(finite, 4);
}

TEST(ShadowMaps, CascadesEndFartherAndFartherAndAtTheFarPlane) {
  for (int count = 1; count <= 4; ++count) {
    const std::vector<double> ends = cascade_ends(0.5, 200, count);
    ASSERT_EQ(ends.size(), static_cast<size_t>(count));
    EXPECT_NEAR(ends.back(), 200, 1e-9);
    for (size_t k = 1; k < ends.size(); ++k) EXPECT_GT(ends[k], ends[k - 1]);
  }
}

TEST(ShadowMaps, SunsComeFirstAndWhatHasNoRoomIsCounted) {
  const std::vector<Light> lights = {light_of(LightKind::point), light_of(LightKind::spot),
                                     light_of(LightKind::directional)};
  const ShadowPlan two = plan_of(lights, {.cascades = 2, .most_lights = 2});
  EXPECT_EQ(two.first_map, (std::vector<int>{2, -1, 0}));
  EXPECT_EQ(two.maps.size(), 8u);
  EXPECT_EQ(two.with, 2);
  EXPECT_EQ(two.without, 1);
  const ShadowPlan suns = plan_of(lights, {.suns_only = true});
  EXPECT_EQ(suns.first_map, (std::vector<int>{-1, -1, 0}));
  EXPECT_EQ(suns.without, 0) << "the others are to have none";
  // Of 4096 texels four maps fit: a cube does not.
  const ShadowPlan large = plan_of(lights, {.map_texels = 4096, .cascades = 3});
  EXPECT_EQ(large.first_map, (std::vector<int>{-1, 3, 0}));
  EXPECT_EQ(large.without, 1);
  EXPECT_TRUE(plan_of({}).maps.empty());
}

TEST(ShadowMaps, OneLightAloneHasWhatItHasAmongTheOthers) {
  const std::vector<Light> lights = {light_of(LightKind::point), light_of(LightKind::spot),
                                     light_of(LightKind::directional)};
  for (size_t i = 0; i < lights.size(); ++i) {
    ShadowPlan plan = plan_of(lights, {.cascades = 2, .most_lights = 2});
    const int maps = plan.first_map[i] < 0 ? 0 : i == 2 ? 2 : i == 0 ? 6 : 1;
    keep_only(plan, i);
    EXPECT_EQ(plan.first_map, (std::vector<int>{maps > 0 ? 0 : -1})) << i;
    EXPECT_EQ(plan.maps.size(), static_cast<size_t>(maps)) << i;
    EXPECT_EQ(plan.size.x > 0, maps > 0) << i;
  }
}

TEST(ShadowMaps, ALightThatReachesNothingTakesNoMap) {
  Light dim = light_of(LightKind::point);
  dim.range = 0;
  const ShadowPlan plan = plan_of({dim, light_of(LightKind::point)}, {.most_lights = 1});
  EXPECT_EQ(plan.first_map, (std::vector<int>{-1, 0}));
  EXPECT_EQ(plan.without, 0);
}

// Without an edge a thousandth of the light is left at the border of the map, which is then not wider than it need be.
TEST(ShadowMaps, ASpotWithoutAnEdgeHasANarrowMap) {
  Light l = light_of(LightKind::spot);
  l.outer_cos = -1, l.inner_cos = 48;
  const ShadowMap m = plan_of({l}).maps.at(0);
  EXPECT_LT(m.texel * 1024 / 2, std::tan(0.6));
  EXPECT_GT(m.texel * 1024 / 2, std::tan(0.4));
}

TEST(ShadowMaps, TilesLieApartInTheirTexture) {
  const ShadowPlan plan =
      plan_of(std::vector<Light>(20, light_of(LightKind::point)), {.map_texels = 512, .most_lights = 20});
  ASSERT_EQ(plan.maps.size(), 120u);
  for (size_t i = 0; i < plan.maps.size(); ++i) {
    const glm::ivec2 a = plan.maps[i].corner;
    EXPECT_TRUE(glm::all(glm::lessThanEqual(a + 512, plan.size)));
    for (size_t j = 0; j < i; ++j) {
      const glm::ivec2 apart = glm::abs(a - plan.maps[j].corner);
      EXPECT_TRUE(apart.x >= 512 || apart.y >= 512);
    }
  }
}

TEST(ShadowMaps, WhatMayHideIsNeverLeftOut) {
  Pcg32 random(4);
  const ShadowPlan plan = plan_of({light_of(LightKind::point), light_of(LightKind::directional, {0.4, -1, -0.3})});
  int left_out = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 a = in_box(random, kScene);
    const Bounds box{a, a + glm::dvec3(random.in(0.1, 4))};
    for (const ShadowMap& m : plan.maps) {
      bool inside = false;
      for (int k = 0; k < 30; ++k) inside |= holds(m, in_box(random, box));
      const bool kept = may_hide(m, kAnchor, box);
      EXPECT_TRUE(kept || !inside);
      left_out += !kept;
    }
  }
  EXPECT_GT(left_out, 500);
}

}  // namespace
}  // namespace gbl
