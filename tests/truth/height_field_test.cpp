// Height fields under triangles, where the answer is known in closed form, and against a walk in small steps.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/truth/height_fields.h"
#include "renderer/truth/light_sight.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

// red(x, y) of a map, 0..1.
template <class F>
Texture height_texture(glm::ivec2 size, F red) {
  Texture t{"heights", size, {}, {}, {.min = Filter::linear}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto code = static_cast<uint16_t>(std::lround(65535 * red(x, y)));
      t.rgba16.insert(t.rgba16.end(), {code, code, code, 65535});
    }
  return t;
}

// A plane at y = 0 from -1 to 1, its map over all of it, `deep` world units down, k units to a unit.
Scene sunken_plane(Texture heights, double deep, double k) {
  Scene scene = make_plane(static_cast<float>(k), Material{.name = "sunken"});
  scene.textures.push_back(std::move(heights));
  Material& m = scene.materials[0];
  m.height_texture = {static_cast<int>(scene.textures.size()) - 1};
  m.height_depth = static_cast<float>(deep);
  for (Vertex& v : scene.meshes[0].vertices)
    v.uv = {0.5 + 0.5 * double(v.position.x) / k, 0.5 + 0.5 * double(v.position.z) / k};
  return scene;
}

Settings sunken_settings(double k) {
  Settings s = closed_settings();
  s.height_map = HeightMap::on;
  s.camera.position = {0, 2 * k, 0};
  return s;
}

// The triangle of the plane under a place.
SeenSurface under(const Scene& scene, const glm::dvec3& p) {
  const Mesh& mesh = scene.meshes[0];
  for (int t = 0; t < static_cast<int>(mesh.indices.size() / 3); ++t) {
    glm::dvec3 c[3];
    for (size_t k = 0; k < 3; ++k) c[k] = mesh.vertices[mesh.indices[3 * static_cast<size_t>(t) + k]].position;
    bool inside = true;
    for (int k = 0; k < 3; ++k) inside &= glm::cross(c[(k + 1) % 3] - c[k], p - c[k]).y >= 0;
    if (inside) return {1, t};
  }
  return {};
}

// A ramp: depth(x) = deep (0.2 + 0.6 x') with x' from the first texel's centre to the last one's.
TEST(HeightField, ALineMeetsARampWhereBothLinesCross) {
  for (const double k : {1.0 / 1024, 1.0, 1048576.0}) {  // exact as float, as vertices are
    constexpr int kSize = 64;
    const double deep = 0.1 * k;
    // Codes in whole steps, so that the ramp is exactly straight.
    const auto code = [](int x) { return (52000.0 - 600.0 * x) / 65535; };
    const Scene scene = sunken_plane(height_texture({kSize, 4}, [&](int x, int) { return code(x); }), deep, k);
    const Settings s = sunken_settings(k);
    const HeightFields fields(s, scene);
    const auto depth_of = [&](double x) {  // x in world units
      const double texel = (0.5 + 0.5 * x / k) * kSize - 0.5;
      return double(scene.materials[0].height_depth) * (1 - (52000.0 - 600.0 * texel) / 65535);
    };
    Pcg32 rng(3);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 met(k * rng.in(-0.5, 0.5), 0, k * rng.in(-0.5, 0.5)),
          way(rng.in(-1, 1), -rng.in(0.3, 1), rng.in(-1, 1));
      const Ray ray{met - k * way - s.camera.position, way};
      const Sunk sunk = fields.sunk(ray, under(scene, met));
      // y + depth(x) = 0 along met + t way, a line in t.
      const double slope = (depth_of(met.x + k) - depth_of(met.x)) / k;
      const double t = depth_of(met.x) / (-way.y - slope * way.x);
      EXPECT_LT(glm::distance(sunk.by, t * way), 1e-9 * k);
      EXPECT_LT(glm::distance(sunk.uv_moved, 0.5 / k * t * glm::dvec2(way.x, way.z)), 1e-9);
    }
  }
}

// Against the first of many small steps that lies below the surface: never below before, and the end on the surface.
TEST(HeightField, EndsWhereALineFirstMeetsRoughGround) {
  Pcg32 rng(7);
  const Scene scene = sunken_plane(height_texture({32, 32}, [&](int, int) { return rng.unit(); }), 0.2, 1);
  const Settings s = sunken_settings(1);
  const HeightFields fields(s, scene);
  const auto depth_at = [&](const glm::dvec2& uv) {  // bilinear, repeated; written apart
    const Texture& t = scene.textures.back();
    const auto red = [&](int x, int y) {
      return t.texel(static_cast<size_t>(((y % 32 + 32) % 32) * 32 + (x % 32 + 32) % 32)).r;
    };
    const double x = uv.x * 32 - 0.5, y = uv.y * 32 - 0.5, fx = x - std::floor(x), fy = y - std::floor(y);
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const double top = red(ix, iy) * (1 - fx) + red(ix + 1, iy) * fx;
    const double bottom = red(ix, iy + 1) * (1 - fx) + red(ix + 1, iy + 1) * fx;
    return double(scene.materials[0].height_depth) * (1 - (top * (1 - fy) + bottom * fy));
  };
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 met(rng.in(-0.9, 0.9), 0, rng.in(-0.9, 0.9)), way(rng.in(-1, 1), -rng.in(0.05, 1), rng.in(-1, 1));
    const Sunk sunk = fields.sunk({met - way - s.camera.position, way}, under(scene, met));
    const double end = sunk.by.y / way.y;
    const auto below = [&](double t) {  // > 0: in the solid
      const glm::dvec3 p = met + t * way;
      return -p.y - depth_at({0.5 + 0.5 * p.x, 0.5 + 0.5 * p.z});
    };
    EXPECT_LT(std::abs(below(end)), 1e-9);
    for (int k = 0; k < 1000; ++k) EXPECT_LT(below(end * k / 1000), 1e-9);
  }
}

// A trench between two level heights: from its ground, light comes in over the wall from this angle on.
TEST(HeightField, ATrenchHidesLowLights) {
  constexpr int kSize = 64;
  const auto red = [](int x, int) { return x >= 24 && x < 40 ? 0.0 : 1.0; };
  const Scene scene = sunken_plane(height_texture({kSize, 4}, red), 0.25, 1);
  Settings s = sunken_settings(1);
  s.shadows = Shadows::all;
  const auto heights = std::make_shared<HeightFields>(s, scene);
  const LightSight sight(s, scene, heights);
  // Texel centres at (i + 0.5) / 32 - 1: the ground from 24 to 39, the wall's top at 40.
  const double top = 40.5 / 32 - 1;
  int seen = 0, hidden = 0;
  for (int across = 0; across < 31; ++across)
    for (int turn = 0; turn < 52; ++turn) {
      const double x = -0.2 + 0.013 * across, angle = 2 + 1.7 * turn;
      TruthLight sun;
      sun.light.kind = LightKind::directional;
      sun.light.direction = -glm::dvec3(std::cos(glm::radians(angle)), std::sin(glm::radians(angle)), 0);
      const glm::dvec3 place(x, -0.25, 0.1);
      const double edge = glm::degrees(std::atan2(0.25, top - x));
      if (std::abs(angle - edge) < 1e-6) continue;
      const bool sees = sight.sees(sun, place - s.camera.position, under(scene, {x, 0, 0.1}));
      EXPECT_EQ(sees, angle > edge) << x << " " << angle;
      ++(sees ? seen : hidden);
    }
  EXPECT_GT(seen, 100);
  EXPECT_GT(hidden, 100);
}

// A shallow valley, all of it sunk by the same depth: from beside its fold a low light is seen over the other side, whose triangles
// are left from behind on the way.
TEST(HeightField, TheBackOfANeighbourIsAWayOut) {
  Scene scene = sunken_plane(height_texture({4, 4}, [](int, int) { return 0.0; }), 0.25, 1);
  const double steep = 0.27;
  Mesh valley{"valley", {}, {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5}};
  for (const float x : {-1.0f, 0.0f, 1.0f})
    for (const float z : {1.0f, -1.0f})
      valley.vertices.push_back({.position = {x, steep * std::abs(double(x)), z}, .normal = {0, 1, 0}, .uv = {x, z}});
  scene.meshes = {valley};
  scene.bounds = bounds_of(scene);
  Settings s = sunken_settings(1);
  s.shadows = Shadows::all;
  const LightSight sight(s, scene, std::make_shared<HeightFields>(s, scene));
  const glm::dvec3 normal = glm::normalize(glm::dvec3(steep, 1, 0)), on_left(-0.02, 0.02 * steep, 0.1);
  TruthLight sun;
  sun.light.kind = LightKind::directional;
  sun.light.direction = -glm::normalize(glm::dvec3(0.9, 0.43, 0));
  const auto sees = [&] { return sight.sees(sun, on_left - 0.25 * normal - s.camera.position, {1, 0}); };
  EXPECT_TRUE(sees());
  sun.light.direction = -glm::normalize(glm::dvec3(-0.9, 0.2, 0));
  EXPECT_FALSE(sees()) << "behind its own plane";
}

TEST(HeightField, BacksAndSurfacesWithoutAMapStayFlat) {
  const Scene scene = sunken_plane(height_texture({4, 4}, [](int, int) { return 0.0; }), 0.25, 1);
  Settings s = sunken_settings(1);
  const SeenSurface surface = under(scene, {0.1, 0, 0.2});
  const Ray from_above{glm::dvec3(0), {0.1, -2, 0.2}}, from_below{{0, -4, 0}, {0.1, 2, 0.2}};
  EXPECT_NEAR(HeightFields(s, scene).sunk(from_above, surface).by.y, -0.25, 1e-12);
  EXPECT_EQ(HeightFields(s, scene).sunk(from_below, surface).by, glm::dvec3(0));
  s.height_map = HeightMap::off;
  EXPECT_EQ(HeightFields(s, scene).sunk(from_above, surface).by, glm::dvec3(0));
}

}  // namespace
}  // namespace gbl::test
