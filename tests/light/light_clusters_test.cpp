// A surface that a light reaches is seen of a cluster that lists the light; lists are tight, in order, and bounded.
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

// A picture's surfaces: at each pixel's centre, from the bottom, how far; 0: none. And what is seen of its blocks.
struct Surfaces {
  Camera camera;
  glm::ivec2 size{0};
  std::vector<double> depth = std::vector<double>(static_cast<size_t>(size.x) * static_cast<size_t>(size.y), 0.0);

  double& at(glm::ivec2 p) { return depth[static_cast<size_t>(p.y * size.x + p.x)]; }
  double at(glm::ivec2 p) const { return depth[static_cast<size_t>(p.y * size.x + p.x)]; }
  glm::dvec3 point(glm::ivec2 p) const {
    const ViewRays rays = view_rays(camera, double(size.x) / size.y);
    const glm::dvec2 ndc = (glm::dvec2(p) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
    const glm::dvec3 aside = ndc.x * rays.right + ndc.y * rays.up;
    return camera.position + at(p) * rays.forward + aside * (camera.orthographic() ? 1 : at(p));
  }
  template <class Use>
  void each(Use use) const {
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (at({x, y}) > 0) use(glm::ivec2(x, y));
  }
  // `off`: as float arithmetic may have it
  std::vector<DepthSpan> blocks(const ClusterGrid& grid, double off = 0) const {
    std::vector<DepthSpan> out(kSpans * static_cast<size_t>(grid.blocks.x * grid.blocks.y));
    each([&](glm::ivec2 p) {
      const auto depth_seen = static_cast<float>(at(p) * (1 + off));
      if (depth_seen > grid.end_of_reach()) return;
      DepthSpan* const spans = &out[kSpans * static_cast<size_t>(p.y / kBlock * grid.blocks.x + p.x / kBlock)];
      const bool first = spans[0].empty() || std::abs(std::log(depth_seen / spans[0].nearest)) < 0.1;
      spans[first ? 0 : 1].add({depth_seen, depth_seen});
    });
    return out;
  }
};

bool built(LightClusters& clusters, const Surfaces& s, std::span<const Light> lights,
           uint32_t most_entries = kMostClusterEntries) {
  const ClusterGrid grid = cut_for(s.camera, s.size, lights);
  return clusters.build(grid, s.blocks(grid), most_entries);
}

// What shaders/light_clustered.frag reads for a pixel.
std::vector<uint32_t> read_at(const LightClusters& clusters, glm::ivec2 pixel, double depth) {
  const ClusterGrid& g = clusters.grid();
  const double slice = std::log2(depth) * g.slice_scale + g.slice_offset;
  const std::span<const uint32_t> list =
      clusters.list(pixel / g.tile_px, std::clamp(static_cast<int>(slice), 0, g.slices - 1));
  std::vector<uint32_t> all(list.begin(), list.end());
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end())) << "the lights' own order";
  all.insert(all.end(), clusters.everywhere().begin(), clusters.everywhere().end());
  EXPECT_EQ(std::set<uint32_t>(all.begin(), all.end()).size(), all.size()) << "a light is read once";
  return all;
}

bool holds(const std::vector<uint32_t>& list, uint32_t light) {
  return std::find(list.begin(), list.end(), light) != list.end();
}

// Smooth here, torn there, and nothing in some places.
Surfaces random_surfaces(Pcg32& random, const Camera& camera, glm::ivec2 size) {
  Surfaces s{camera, size};
  const double torn = random.in(0, 0.2), base = random.in(0, 1), slope = random.in(-0.5, 0.5);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const double smooth = std::clamp(base + slope * x / size.x, 0.0, 1.0);
      const double along = random.in(0, 1) < torn ? random.in(0, 1) : smooth;
      s.at({x, y}) = random.in(0, 1) < 0.1 ? 0 : camera.near * std::pow(camera.far / camera.near, along);
    }
  return s;
}

glm::ivec2 random_size(Pcg32& random) { return {1 + random.next() % 150, 1 + random.next() % 90}; }

TEST(LightClusters, EveryPixelReadsTheLightsThatReachIt) {
  Pcg32 random(11);
  LightClusters clusters;
  int pairs = 0, listed = 0;
  for (int k = 0; k < 150; ++k) {
    const Camera c = random_camera(random, k % 4 == 0);
    const Surfaces seen = random_surfaces(random, c, random_size(random));
    std::vector<Light> lights(k % 10 == 9 ? 300 : 1 + random.next() % 40);  // 300: on two threads
    for (Light& l : lights) l = light_of(random, c);
    built(clusters, seen, lights);
    listed += static_cast<int>(lights.size() - clusters.everywhere().size());
    seen.each([&](glm::ivec2 p) {
      if (random.next() % 8) return;
      const std::vector<uint32_t> read = read_at(clusters, p, seen.at(p));
      for (uint32_t l = 0; l < lights.size(); ++l) {
        if (!reaches(lights[l], seen.point(p))) continue;
        ++pairs;
        ASSERT_TRUE(holds(read, l)) << fmt::format("{}: light {}, pixel {} {} at {}", k, l, p.x, p.y, seen.at(p));
      }
    });
  }
  EXPECT_GT(pairs, 100000);
  EXPECT_GT(listed, 2000);
}

// Surfaces just within the rim of a light, where rounding would show: of the depths, and of the slice that is read.
TEST(LightClusters, BordersBelongToBothSides) {
  Pcg32 random(12);
  LightClusters clusters;
  int asked = 0;
  for (int k = 0; k < 60; ++k) {
    const Camera c = random_camera(random, k % 4 == 0);
    std::vector<Light> lights(20);
    for (Light& l : lights) l = light_of(random, c), l.kind = LightKind::point;
    Surfaces seen{c, {300, 200}};
    std::vector<std::pair<glm::ivec2, uint32_t>> rims;
    for (int y = 3; y < seen.size.y; y += kBlock)  // one of a block, so that no neighbour hides a mistake
      for (int x = 3; x < seen.size.x; x += kBlock) {
        const glm::ivec2 p(x, y);
        const uint32_t l = random.next() % 20;
        // Where the pixel's ray enters the ball, or leaves it.
        seen.at(p) = 1;
        const glm::dvec3 one = seen.point(p);
        seen.at(p) = 2;
        const glm::dvec3 along = seen.point(p) - one, from = one - along - lights[l].position;
        const double a = glm::dot(along, along), b = glm::dot(along, from),
                     root = b * b - a * (glm::dot(from, from) - std::pow(lights[l].range * (1 - 1e-9), 2));
        const double depth = root > 0 ? (-b + (random.next() % 2 ? 1 : -1) * std::sqrt(root)) / a : 0;
        seen.at(p) = depth > c.near && depth < c.far ? depth : 0;
        if (seen.at(p) > 0) rims.emplace_back(p, l);
      }
    for (const double off : {-1e-6, 0.0, 1e-6}) {
      const ClusterGrid grid = cut_for(c, seen.size, lights);
      clusters.build(grid, seen.blocks(grid, off));
      for (const auto& [p, l] : rims) {
        ++asked;
        ASSERT_TRUE(holds(read_at(clusters, p, seen.at(p) * (1 - off)), l)) << k << ", light " << l << ", " << off;
      }
    }
  }
  EXPECT_GT(asked, 10000);
}

// Surfaces at the borders of slices: the shader may read the one before or the one behind.
TEST(LightClusters, SlicesOverlapAtTheirBorders) {
  Surfaces seen{Camera{}, {300, 200}};
  seen.camera.near = 0.1, seen.camera.far = 100;
  std::vector<Light> lights(30);
  Pcg32 random(17);
  for (Light& l : lights) l.position = {random.in(-5, 5), random.in(-5, 5), random.in(-40, -5)}, l.range = 6;
  const ClusterGrid grid = cut_for(seen.camera, seen.size, lights);
  LightClusters clusters;
  int pairs = 0;
  for (int slice = 1; slice < grid.slices; ++slice)
    for (const double off : {-2e-5, 2e-5}) {
      std::fill(seen.depth.begin(), seen.depth.end(), double(grid.slice_edges[slice]));
      clusters.build(grid, seen.blocks(grid, off));
      seen.each([&](glm::ivec2 p) {
        if (p.x % 20 || p.y % 20) return;
        const std::vector<uint32_t> read = read_at(clusters, p, seen.at(p) * (1 - off));
        for (uint32_t l = 0; l < lights.size(); ++l)
          if (reaches(lights[l], seen.point(p))) {
            ++pairs;
            ASSERT_TRUE(holds(read, l)) << slice << " " << off;
          }
      });
    }
  EXPECT_GT(pairs, 10000);
}

// A light across the far plane reaches surfaces there, on whichever side of it their depths are rounded.
TEST(LightClusters, TheFarPlaneBelongsToTheLastSlice) {
  Surfaces seen{Camera{}, {64, 64}};
  seen.camera.near = 0.1, seen.camera.far = 100;
  std::vector<Light> lights(1);
  lights[0].position = {0, 0, -95}, lights[0].range = 20;
  LightClusters clusters;
  for (const double off : {-1e-3, -1e-7, 0.0, 1e-7, 1e-3}) {
    std::fill(seen.depth.begin(), seen.depth.end(), seen.camera.far * (1 + off));
    built(clusters, seen, lights);
    EXPECT_TRUE(holds(read_at(clusters, {32, 32}, seen.at({32, 32})), 0)) << off;
    EXPECT_FALSE(holds(read_at(clusters, {1, 1}, seen.at({1, 1})), 0)) << off << ": aside";
  }
}

// Lights grow by what stored positions may be off: 1000 units from the origin a half float has steps of half a unit.
TEST(LightClusters, LightsGrowByWhatPositionsMayBeOff) {
  Camera c;
  c.position = {1000, 0, 1000};
  std::vector<Light> lights(1);
  lights[0].position = {1000, 0, 990}, lights[0].range = 0.1;
  const auto radius = [&](const PositionStep& step) { return cut_for(c, {64, 64}, lights, step).reaches.at(0).radius; };
  EXPECT_LT(radius({}), 0.11);
  EXPECT_GT(radius({.of_coordinate = 1.0 / 1024}), 1.0);
  EXPECT_GT(radius({.of_distance = 1.0 / 1024}), 0.109);
  EXPECT_GT(radius({.world = 0.1}), 0.2);
}

TEST(LightClusters, TilesGrowWhereADriverHasLittleRoom) {
  const Camera c = Camera{};
  std::vector<Light> lights(10);
  for (size_t i = 0; i < lights.size(); ++i) lights[i].position = {double(i), 0, -20}, lights[i].range = 15;
  const auto heads = [&](size_t most) {
    const ClusterGrid g = cut_for(c, {2560, 1440}, lights, {}, most);
    return static_cast<size_t>(g.tile_count() * (1 + g.slices));
  };
  EXPECT_GT(heads(1u << 30), 500000u);
  EXPECT_LE(heads(32768), 32768u) << "half of what OpenGL promises";
}

// A tilted plane through a hundred units of space.
Surfaces plane(glm::ivec2 size) {
  Camera c;
  c.position = {0, 0, 10}, c.near = 0.1, c.far = 200;
  Surfaces s{c, size};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) s.at({x, y}) = 20 + 80.0 * (x + y) / (size.x + size.y);
  return s;
}

std::vector<Light> lights_about(int count, double range) {
  Pcg32 random(13);
  std::vector<Light> lights(static_cast<size_t>(count));
  for (Light& l : lights) l.position = {random.in(-50, 50), random.in(-50, 50), random.in(-100, 0)}, l.range = range;
  return lights;
}

double read_per_lit(const LightClusters& clusters, const Surfaces& seen, const std::vector<Light>& lights) {
  double read = 0, lit = 0;
  seen.each([&](glm::ivec2 p) {
    read += static_cast<double>(read_at(clusters, p, seen.at(p)).size());
    for (const Light& l : lights) lit += reaches(l, seen.point(p));
  });
  return read / lit;
}

// Of a tile's side over a light's width: what a square of tiles over a square light would read, and some more for the
// tile's depth on this slanted plane. A ball that a cube of half its size may meet at random is met 2.5 times as often as its volume.
double fair_ratio(double tile_over_light) {
  return tile_over_light <= 0.25 ? 2 : (tile_over_light < 0.5 ? 1.4 : 1.7) * std::pow(1 + tile_over_light, 2);
}

TEST(LightClusters, ListsAreTight) {
  const Surfaces seen = plane({320, 180});
  LightClusters clusters;
  for (const double range : {2.0, 4.0, 8.0, 12.0, 25.0}) {
    const std::vector<Light> lights = lights_about(range < 4 ? 2000 : 500, range);
    built(clusters, seen, lights);
    ASSERT_TRUE(clusters.grid().looks) << range << ": where few lights are, lists are of whole clusters";
    const double ratio = read_per_lit(clusters, seen, lights), tile = clusters.grid().tile_px;
    EXPECT_LT(ratio, fair_ratio(tile / clusters.grid().light_px)) << range;
    EXPECT_GE(ratio, 1);
  }
}

TEST(LightClusters, WhereNothingIsSeenNothingIsListed) {
  Surfaces seen = plane({320, 180});
  const std::vector<Light> lights = lights_about(200, 10);
  LightClusters clusters;
  built(clusters, seen, lights);
  const size_t all = clusters.entry_count();
  seen.each([&](glm::ivec2 p) { seen.at(p) = p.x < 160 ? seen.at(p) : 0; });
  built(clusters, seen, lights);
  EXPECT_LT(clusters.entry_count(), all * 3 / 4);
  EXPECT_GT(clusters.entry_count(), all / 4);
  std::fill(seen.depth.begin(), seen.depth.end(), 0.0);
  built(clusters, seen, lights);
  EXPECT_EQ(clusters.entry_count(), 0u);
  EXPECT_EQ(clusters.cluster_count(), 0u);
}

// Where lights cover little there is little to save: one wait for the GPU takes as long as three tests for each pixel.
TEST(LightClusters, SurfacesAreLookedForWhereItPays) {
  const Camera c = plane({1, 1}).camera;
  EXPECT_FALSE(cut_for(c, {1280, 720}, lights_about(20, 2)).looks);
  EXPECT_TRUE(cut_for(c, {1280, 720}, lights_about(2000, 10)).looks);
  EXPECT_FALSE(cut_for(c, {1280, 720}, {}).looks);
}

// Larger tiles for more pairs of a light and a tile, and smaller ones for small lights: see cluster_grid.cpp.
TEST(LightClusters, TilesFitTheLights) {
  const Camera c = plane({1, 1}).camera;
  EXPECT_EQ(cut_for(c, {1280, 720}, lights_about(50, 20)).tile_px, 16);
  EXPECT_EQ(cut_for(c, {1280, 720}, lights_about(50, 0.5)).tile_px, 8);
  EXPECT_EQ(cut_for(c, {1280, 720}, lights_about(16384, 20)).tile_px, 64);
  const ClusterGrid odd = cut_for(c, {1, 17}, lights_about(50, 20));
  EXPECT_GE(odd.tiles.y * odd.tile_px, 17);
  EXPECT_GE(odd.blocks.y * kBlock, 17);
}

TEST(LightClusters, AWideLightIsReadEverywhereAndANarrowOneIsNot) {
  Surfaces seen{Camera{}, {64, 64}};
  seen.camera.far = 100;
  std::fill(seen.depth.begin(), seen.depth.end(), 50.0);
  std::vector<Light> lights(4);
  lights[0].range = 1000;                                  // holds all that can be seen
  lights[1].position = {0, 0, -50}, lights[1].range = 48;  // all that is
  lights[2].position = {0, 0, -50}, lights[2].range = 2;
  lights[3].position = {0, 0, 50}, lights[3].range = 2;  // behind the camera
  LightClusters clusters;
  built(clusters, seen, lights);
  EXPECT_EQ(std::vector<uint32_t>(clusters.everywhere().begin(), clusters.everywhere().end()),
            (std::vector<uint32_t>{0, 1}));
  EXPECT_GT(clusters.entry_count(), 0u);
  EXPECT_EQ(read_at(clusters, {32, 32}, 50), (std::vector<uint32_t>{2, 0, 1}));
  EXPECT_EQ(read_at(clusters, {1, 1}, 50), (std::vector<uint32_t>{0, 1}));
  built(clusters, seen, {});
  EXPECT_EQ(clusters.entry_count(), 0u);
  EXPECT_TRUE(clusters.everywhere().empty());
}

TEST(LightClusters, WhatIsToStandLastDoesSoFromAWholeTexelOn) {
  const Surfaces s{.camera = {}, .size = {64, 48}};
  std::vector<Light> lights(11);
  for (Light& l : lights) l.range = kEndless;
  ClusterGrid grid = cut_for(s.camera, s.size, lights);
  grid.last = {2, 7};
  LightClusters clusters;
  clusters.build(grid, s.blocks(grid));
  const std::vector<uint32_t> others = {0, 1, 3, 4, 5, 6, 8, 9, 10};
  std::vector<uint32_t> expected = others;
  expected.resize(12, 11);  // no light
  expected.insert(expected.end(), {2, 7});
  const std::span<const uint32_t> everywhere = clusters.everywhere();
  EXPECT_EQ(std::vector(everywhere.begin(), everywhere.end()), expected);
  EXPECT_EQ(clusters.last_ones_everywhere(), 2u);
}

TEST(LightClusters, MemoryIsBoundedAndNoLightIsDropped) {
  Settings s = preset("start").make();
  s.lights.count = kMaxLights;
  Pcg32 random(16);
  const Surfaces seen = random_surfaces(random, s.camera, {640, 360});
  LightClusters clusters;
  for (const double scale : {1.0, 8.0, 30.0, 1000.0}) {
    s.lights.range_scale = scale;
    const std::vector<Light> lights = lights_of(s, Scene{});
    built(clusters, seen, lights);
    EXPECT_LE(clusters.entry_count(), kMostClusterEntries) << scale;
    EXPECT_EQ(scale >= 1000, clusters.everywhere().size() == lights.size()) << scale;
  }
}

// The widest go first, all others stay listed, and whoever reads finds the same lights.
TEST(LightClusters, OverABudgetTheWidestLightsAreReadEverywhere) {
  const Surfaces seen = plane({160, 90});
  std::vector<Light> lights = lights_about(300, 3);
  for (size_t i = 0; i < lights.size(); i += 20) lights[i].range = 30;
  LightClusters all, some;
  built(all, seen, lights);
  const auto budget = static_cast<uint32_t>(all.entry_count() / 2);
  built(some, seen, lights, budget);
  EXPECT_LE(some.entry_count(), budget);
  EXPECT_GT(some.entry_count(), budget / 2);
  EXPECT_GT(some.everywhere().size(), all.everywhere().size());
  EXPECT_LT(some.everywhere().size(), lights.size() / 10) << "half of the entries belong to few lights";
  EXPECT_TRUE(std::is_sorted(some.everywhere().begin(), some.everywhere().end()));
  for (const uint32_t l : some.everywhere()) EXPECT_EQ(l % 20, 0u) << "a wide one";
  seen.each([&](glm::ivec2 p) {
    const std::vector<uint32_t> after = read_at(some, p, seen.at(p));
    for (const uint32_t l : read_at(all, p, seen.at(p))) EXPECT_TRUE(holds(after, l));
  });
}

TEST(LightClusters, ABuildDependsOnNothingThatWasBuiltBefore) {
  Pcg32 random(15);
  const Camera c = random_camera(random, false);
  const Surfaces seen = random_surfaces(random, c, {100, 70});
  std::vector<Light> lights(40);
  for (Light& l : lights) l = light_of(random, c);
  LightClusters fresh, used;
  built(fresh, seen, lights);
  built(used, random_surfaces(random, random_camera(random, true), {333, 20}), std::vector<Light>(300));
  built(used, seen, lights);
  EXPECT_TRUE(std::equal(fresh.words().begin(), fresh.words().end(), used.words().begin(), used.words().end()));
  EXPECT_EQ(fresh.everywhere_texel(), used.everywhere_texel());
}

TEST(LightClusters, ListsAreKeptWhileNothingMoves) {
  Surfaces seen = plane({64, 36});
  std::vector<Light> lights = lights_about(50, 10);
  LightClusters clusters;
  EXPECT_TRUE(built(clusters, seen, lights));
  EXPECT_FALSE(built(clusters, seen, lights));
  lights[7].position.x += 1e-3;
  EXPECT_TRUE(built(clusters, seen, lights)) << "a light has moved";
  seen.at({5, 5}) *= 1.2;
  EXPECT_TRUE(built(clusters, seen, lights)) << "a surface has moved";
  EXPECT_TRUE(built(clusters, seen, lights, 10)) << "there is less room";
  seen.camera.position.y += 1e-3;
  EXPECT_TRUE(built(clusters, seen, lights, 10)) << "the camera has moved";
  EXPECT_FALSE(built(clusters, seen, lights, 10));
  clusters.forget();
  EXPECT_TRUE(built(clusters, seen, lights, 10));
}

}  // namespace
}  // namespace gbl
