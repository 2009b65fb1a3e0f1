// A point that a light reaches lies in a cluster that lists the light; lists are tight, in order, and bounded.
#include "renderer/light/light_clusters.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "renderer/frame/frame_lights.h"
#include "renderer/light/light_bounds.h"
#include "renderer/light/lights.h"
#include "renderer/options/presets.h"
#include "tests/random_view.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

Light light_of(Pcg32& random, const Camera& c) {
  Light l;
  l.kind = std::array{LightKind::point, LightKind::point, LightKind::spot, LightKind::directional}[random.next() % 4];
  l.range = std::exp(random.in(-2, 5));
  l.position = c.position + c.forward() * random.in(-10, 120) + random_direction(random) * random.in(0, 60);
  l.direction = random_direction(random);
  l.outer_cos = std::cos(random.in(0, 3.14159));
  return l;
}

bool reaches(const Light& l, const glm::dvec3& point) {
  if (l.kind == LightKind::directional) return true;
  const glm::dvec3 away = point - l.position;
  const double d = glm::length(away);
  return d < l.range && (l.kind == LightKind::point || glm::dot(away, l.direction) > l.outer_cos * d);
}

std::vector<uint32_t> read_at(const LightClusters& clusters, glm::dvec2 ndc, double depth) {
  const auto list = clusters.list(clusters.cluster_at(ndc, depth));
  std::vector<uint32_t> all(list.begin(), list.end());
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end())) << "the lights' own order";
  all.insert(all.end(), clusters.everywhere().begin(), clusters.everywhere().end());
  EXPECT_EQ(std::set<uint32_t>(all.begin(), all.end()).size(), all.size()) << "a light is read once";
  return all;
}

glm::dvec3 point_of(const Camera& c, double aspect, glm::dvec2 ndc, double depth) {
  const ViewRays rays = view_rays(c, aspect);
  const glm::dvec3 aside = ndc.x * rays.right + ndc.y * rays.up;
  return c.position + depth * rays.forward + aside * (c.orthographic() ? 1 : depth);
}

TEST(LightClusters, EveryPointInReachOfALightLiesInAClusterThatListsIt) {
  Pcg32 random(11);
  LightClusters clusters;
  int pairs = 0, listed = 0;
  for (int k = 0; k < 300; ++k) {
    const Camera c = random_camera(random, k % 4 == 0);
    const double aspect = random.in(0.5, 2.5);
    std::vector<Light> lights(1 + random.next() % 60);
    for (Light& l : lights) l = light_of(random, c);
    clusters.build(c, aspect, lights);
    listed += static_cast<int>(lights.size() - clusters.everywhere().size());
    for (int i = 0; i < 300; ++i) {
      const glm::dvec2 ndc(random.in(-1, 1), random.in(-1, 1));
      const double depth = i % 2 ? random.in(c.near, c.far) : c.near * std::pow(c.far / c.near, random.in(0, 1));
      const std::vector<uint32_t> read = read_at(clusters, ndc, depth);
      const glm::dvec3 point = point_of(c, aspect, ndc, depth);
      for (uint32_t l = 0; l < lights.size(); ++l) {
        if (!reaches(lights[l], point)) continue;
        ++pairs;
        ASSERT_TRUE(std::find(read.begin(), read.end(), l) != read.end())
            << fmt::format("{}: light {} reaches {} {} at depth {}", k, l, ndc.x, ndc.y, depth);
      }
    }
  }
  EXPECT_GT(pairs, 100000);
  EXPECT_GT(listed, 3000);
}

// Points on the very border of clusters and of lights: where rounding would show.
TEST(LightClusters, BordersBelongToBothSides) {
  Pcg32 random(12);
  LightClusters clusters;
  for (int k = 0; k < 100; ++k) {
    const Camera c = random_camera(random, k % 4 == 0);
    std::vector<Light> lights(20);
    for (Light& l : lights) l = light_of(random, c), l.kind = LightKind::point;
    clusters.build(c, 1.6, lights);
    for (uint32_t l = 0; l < lights.size(); ++l)
      for (int i = 0; i < 40; ++i) {
        const glm::dvec3 rim =
            view_of(c, lights[l].position + random_direction(random) * (lights[l].range * (1 - 1e-9)));
        const ViewRays rays = view_rays(c, 1.6);
        const double width = c.orthographic() ? 1 : rim.z;
        const glm::dvec2 ndc(rim.x / width / glm::length(rays.right), rim.y / width / glm::length(rays.up));
        if (rim.z < c.near || rim.z > c.far || largest(glm::abs(ndc)) > 1) continue;
        // As float arithmetic may have it: a millionth to either side.
        for (const double off : {-1e-6, 0.0, 1e-6}) {
          const std::vector<uint32_t> read = read_at(clusters, ndc * (1 + off), rim.z * (1 - off));
          ASSERT_TRUE(std::find(read.begin(), read.end(), l) != read.end()) << k << ", light " << l << ", " << off;
        }
      }
  }
}

// A hundred units of space, lights of range 20: lists that are no longer than they must be.
TEST(LightClusters, ListsAreTight) {
  Pcg32 random(13);
  std::vector<Light> lights(200);
  for (Light& l : lights) l.position = {random.in(-50, 50), random.in(-50, 50), random.in(-100, 0)}, l.range = 20;
  Camera c;
  c.position = {0, 0, 10}, c.near = 0.1, c.far = 200;
  LightClusters clusters;
  clusters.build(c, 16.0 / 9, lights);
  double read = 0, lit = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 ndc(random.in(-1, 1), random.in(-1, 1));
    const double depth = random.in(10, 110);
    read += static_cast<double>(read_at(clusters, ndc, depth).size());
    const glm::dvec3 point = point_of(c, 16.0 / 9, ndc, depth);
    for (const Light& l : lights) lit += reaches(l, point);
  }
  EXPECT_LT(read / lit, 2) << read << " read for " << lit;
  EXPECT_GE(read / lit, 1);
}

size_t entries(const LightClusters& c) {
  size_t sum = 0;
  for (int i = 0; i < kClusterCount; ++i) sum += c.list(i).size();
  return sum;
}

TEST(LightClusters, AWideLightIsReadEverywhereAndANarrowOneIsNot) {
  Camera c;
  c.far = 100;
  std::vector<Light> lights(4);
  lights[0].range = 1000;                                  // holds all that can be seen
  lights[1].position = {0, 0, -50}, lights[1].range = 48;  // most of it
  lights[2].position = {0, 0, -50}, lights[2].range = 2;
  lights[3].position = {0, 0, 50}, lights[3].range = 2;  // behind the camera
  LightClusters clusters;
  clusters.build(c, 1, lights);
  EXPECT_EQ(std::vector<uint32_t>(clusters.everywhere().begin(), clusters.everywhere().end()),
            (std::vector<uint32_t>{0, 1}));
  EXPECT_GT(entries(clusters), 0u);
  EXPECT_LT(entries(clusters), size_t(kClusterCount) / 10);
  for (int i = 0; i < kClusterCount; ++i)
    for (const uint32_t l : clusters.list(i)) EXPECT_EQ(l, 2u);
  clusters.build(c, 1, {});
  EXPECT_EQ(entries(clusters), 0u);
  EXPECT_TRUE(clusters.everywhere().empty());
}

TEST(LightClusters, MemoryIsBoundedAndNoLightIsDropped) {
  Settings s = preset("start").make();
  s.lights.count = kMaxLights;
  LightClusters clusters;
  for (const double scale : {1.0, 8.0, 30.0, 1000.0}) {
    s.lights.range_scale = scale;
    const std::vector<Light> lights = lights_of(s, Scene{});
    clusters.build(s.camera, 16.0 / 9, lights);
    EXPECT_LE(entries(clusters), kMostClusterEntries) << scale;
    EXPECT_EQ(scale >= 1000, clusters.everywhere().size() == lights.size()) << scale;
  }
}

// The widest go first, all others stay listed, and whoever reads finds the same lights.
TEST(LightClusters, OverABudgetTheWidestLightsAreReadEverywhere) {
  Pcg32 random(14);
  const Camera c = random_camera(random, false);
  std::vector<Light> lights(300);
  for (Light& l : lights) l = light_of(random, c), l.kind = LightKind::point, l.range = std::min(l.range, 15.0);
  LightClusters all, some;
  all.build(c, 1.5, lights);
  const auto budget = static_cast<uint32_t>(entries(all) / 2);
  some.build(c, 1.5, lights, budget);
  EXPECT_LE(entries(some), budget);
  EXPECT_GT(entries(some), budget / 2);
  EXPECT_GT(some.everywhere().size(), all.everywhere().size());
  EXPECT_LT(some.everywhere().size(), lights.size() / 2) << "half of the entries belong to few lights";
  EXPECT_TRUE(std::is_sorted(some.everywhere().begin(), some.everywhere().end()));
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 ndc(random.in(-1, 1), random.in(-1, 1));
    const double depth = random.in(c.near, c.far);
    const std::vector<uint32_t> before = read_at(all, ndc, depth), after = read_at(some, ndc, depth);
    const std::set<uint32_t> found(after.begin(), after.end());
    for (const uint32_t l : before) EXPECT_EQ(found.count(l), 1u);
  }
}

TEST(LightClusters, ABuildDependsOnNothingThatWasBuiltBefore) {
  Pcg32 random(15);
  const Camera c = random_camera(random, false);
  std::vector<Light> lights(40);
  for (Light& l : lights) l = light_of(random, c);
  LightClusters fresh, used;
  fresh.build(c, 1.2, lights);
  used.build(random_camera(random, true), 2, std::vector<Light>(100));
  used.build(c, 1.2, lights);
  EXPECT_TRUE(std::equal(fresh.words().begin(), fresh.words().end(), used.words().begin(), used.words().end()));
  EXPECT_EQ(fresh.everywhere_texel(), used.everywhere_texel());
}

}  // namespace
}  // namespace gbl
