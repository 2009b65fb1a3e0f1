#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <string>

#include "renderer/scenes/builtin_scenes.h"
#include "tests/scenes/mesh_promises.h"

namespace gbl {
namespace {

constexpr int kSide = 257;

const Scene& terrain() {
  static const Scene scene = load_scene("builtin:terrain");
  return scene;
}

const Instance& instance(const std::string& name) {
  for (const Instance& i : terrain().instances)
    if (i.name == name) return i;
  throw std::out_of_range("no instance " + name);
}

const Mesh& mesh_of(const Instance& i) { return terrain().meshes[i.mesh]; }

float height(int x, int z) { return mesh_of(instance("ground")).vertices[z * kSide + x].position.y; }

glm::dvec3 world(const Instance& i, const Vertex& v) {
  return glm::dvec3(i.world_from_object * glm::dvec4(glm::dvec3(v.position), 1));
}

// The ground under a point, from the very triangle that is drawn there.
double ground_below(double x, double z) {
  const int column = static_cast<int>(x / 16), row = static_cast<int>(z / 16);
  const double u = x / 16 - column, v = z / 16 - row;
  const double a = height(column, row), b = height(column + 1, row);
  const double c = height(column, row + 1), d = height(column + 1, row + 1);
  if (u + v <= 1) return a + (b - a) * u + (c - a) * v;
  return d + (c - d) * (1 - u) + (b - d) * (1 - v);
}

TEST(Terrain, HeightsAreHillsUnderTheLightsAndRidgesBeyond) {
  float lowest = 1e9f, hills_low = 1e9f, hills_high = -1e9f, highest = -1e9f;
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      const float y = height(x, z);
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
      if (std::hypot(x * 16 - 2056.0, z * 16 - 2056.0) > 2000) continue;
      hills_low = std::min(hills_low, y);
      hills_high = std::max(hills_high, y);
    }
  EXPECT_GE(lowest, 0);
  EXPECT_LT(hills_low, 10);  // the hills use their range: a plain would pass the next line
  EXPECT_GT(hills_high, 65);
  EXPECT_LE(hills_high, 80);
  EXPECT_EQ(highest, 319);
}

TEST(Terrain, HasHillsWithoutCliffsAndRidgesWithoutNeedles) {
  double steepest = 0, steepest_hill = 0;
  for (int z = 0; z + 1 < kSide; ++z)
    for (int x = 0; x + 1 < kSide; ++x) {
      const double slope =
          std::max(std::abs(height(x + 1, z) - height(x, z)), std::abs(height(x, z + 1) - height(x, z))) / 16;
      steepest = std::max(steepest, slope);
      if (std::hypot(x * 16 - 2056.0, z * 16 - 2056.0) < 1980) steepest_hill = std::max(steepest_hill, slope);
    }
  EXPECT_LT(steepest_hill, 0.6);
  EXPECT_GT(steepest_hill, 0.2);  // some shading to see
  EXPECT_LT(steepest, 1.5);       // ridges, not needles
}

TEST(Terrain, IsTheSameEverywhereAndEachTime) {
  uint64_t hash = 14695981039346656037ull;  // FNV-1a
  for (const Vertex& v : mesh_of(instance("ground")).vertices) {
    uint32_t bits;
    std::memcpy(&bits, &v.position.y, sizeof bits);
    hash = (hash ^ bits) * 1099511628211ull;
  }
  EXPECT_EQ(hash, 18027036649286973106ull);
  const Scene again = build_terrain();
  for (size_t i = 0; i < again.textures.size(); ++i) EXPECT_EQ(again.textures[i].rgba, terrain().textures[i].rgba);
}

TEST(Terrain, GroundIsTheGridOfSourceZero) {
  const Mesh& ground = mesh_of(instance("ground"));
  ASSERT_EQ(ground.vertices.size(), 257u * 257u);
  EXPECT_EQ(ground.indices.size(), 256u * 256u * 6u);
  EXPECT_EQ(ground.vertices.back().position.x, 4096);
  EXPECT_EQ(ground.vertices.back().position.z, 4096);
  EXPECT_EQ(ground.vertices.back().uv, glm::vec2(16, 16));
  // The normal is that of the central differences: compare with the slope where it is not level.
  const Vertex& v = ground.vertices[100 * kSide + 90];
  EXPECT_NEAR(-v.normal.x / v.normal.y, (height(91, 100) - height(89, 100)) / 32, 1e-5);
  EXPECT_NEAR(-v.normal.z / v.normal.y, (height(90, 101) - height(90, 99)) / 32, 1e-5);
  EXPECT_GT(v.tangent.x, 0.8f);
  EXPECT_EQ(v.tangent.z, 0);
}

TEST(Terrain, EveryMeshKeepsItsPromises) {
  for (const Mesh& mesh : terrain().meshes) EXPECT_EQ(broken_promise(mesh), "") << mesh.name;
}

TEST(Terrain, EverythingIsNamedOnceAndRefersToWhatThereIs) {
  const Scene& s = terrain();
  std::vector<std::string> names;
  for (const Instance& i : s.instances) {
    names.push_back(i.name);
    ASSERT_LT(static_cast<size_t>(i.mesh), s.meshes.size());
    ASSERT_LT(static_cast<size_t>(i.material), s.materials.size());
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (const char* name : {"ground", "arch", "lamp-post", "cow 1", "cow 2", "wall", "boulder 1"})
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), std::string(name))) << name;
  const int count = static_cast<int>(s.textures.size());
  for (const Material& m : s.materials)
    for (const TextureUse& t : {m.base_colour_texture, m.normal_texture, m.roughness_texture})
      EXPECT_LT(t.texture, count) << m.name;
  for (const Texture& t : s.textures)
    EXPECT_EQ(t.rgba.size(), static_cast<size_t>(t.size.x) * static_cast<size_t>(t.size.y) * 4) << t.name;
  EXPECT_EQ(s.bounds.min, bounds_of(s).min);
  EXPECT_EQ(s.bounds.max.y, 319);
}

TEST(Terrain, ThingsStandOnTheGround) {
  for (const Instance& i : terrain().instances) {
    if (i.name == "ground") continue;
    double lowest = 1e9, highest_above = -1e9, deepest = 0;
    for (const Vertex& v : mesh_of(i).vertices) lowest = std::min(lowest, static_cast<double>(v.position.y));
    for (const Vertex& v : mesh_of(i).vertices) {
      const glm::dvec3 p = world(i, v);
      const double above = p.y - ground_below(p.x, p.z);
      if (v.position.y < lowest + 1) {
        EXPECT_LT(above, 0) << i.name << " floats";
        deepest = std::min(deepest, above);
      }
      highest_above = std::max(highest_above, above);
    }
    EXPECT_GT(deepest, i.name.substr(0, 3) == "cow" ? -5 : -25) << i.name << " is buried";
    EXPECT_GT(highest_above, 12) << i.name;
  }
}

TEST(Terrain, ThingsHaveTheSizesThatWereAskedFor) {
  const auto extent = [](const char* name) {
    Scene one;
    one.meshes = {mesh_of(instance(name))};
    one.instances = {{name, 0, 0, glm::dmat4(1)}};
    return bounds_of(one).extent();
  };
  EXPECT_NEAR(extent("cow 1").x, 75, 4);
  EXPECT_NEAR(extent("arch").x, 170, 4);
  EXPECT_NEAR(extent("arch").y, 150 + 14, 4);  // 14 of it are below the ground
  EXPECT_NEAR(extent("lamp-post").y, 130 + 8, 1);
}

TEST(Terrain, BumpyWallsFaceEveryWay) {
  for (const char* name : {"arch", "wall"}) {
    const Instance& i = instance(name);
    EXPECT_NE(terrain().materials[i.material].normal_texture.texture, kNoTexture);
    const Mesh& mesh = mesh_of(i);
    for (const glm::dvec3 way : {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) {
      double area = 0;
      for (size_t k = 0; k < mesh.indices.size(); k += 3) {
        const glm::dvec3 a = world(i, mesh.vertices[mesh.indices[k]]), b = world(i, mesh.vertices[mesh.indices[k + 1]]);
        const glm::dvec3 face = glm::cross(b - a, world(i, mesh.vertices[mesh.indices[k + 2]]) - a);
        if (glm::dot(glm::normalize(face), way) > 0.99) area += glm::length(face) / 2;
      }
      EXPECT_GT(area, 500) << name << " towards " << way.x << ", " << way.z;
    }
  }
}

TEST(Terrain, StartCameraShowsEveryThingWhole) {
  const Camera& camera = terrain().camera;
  EXPECT_EQ(camera.position, glm::dvec3(2470, 340, 3320));
  EXPECT_NEAR(yaw_pitch_of(camera.orientation).x, 7, 1e-9);
  EXPECT_NEAR(yaw_pitch_of(camera.orientation).y, -23, 1e-9);
  const glm::dmat4 clip = clip_from_relative(camera, 16.0 / 9);
  for (const Instance& i : terrain().instances) {
    if (i.name == "ground") continue;
    glm::dvec2 low(1e9), high(-1e9);
    for (const Vertex& v : mesh_of(i).vertices) {
      const glm::dvec4 c = clip * glm::dvec4(world(i, v) - camera.position, 1);
      ASSERT_GT(c.w, camera.near);
      const glm::dvec2 pixel((c.x / c.w * 0.5 + 0.5) * 1280, (0.5 - c.y / c.w * 0.5) * 720);
      low = glm::min(low, pixel);
      high = glm::max(high, pixel);
    }
    EXPECT_GT(std::min(low.x, low.y), 8) << i.name;
    EXPECT_LT(high.x, 1272) << i.name;
    EXPECT_LT(high.y, 712) << i.name;
    if (i.name.substr(0, 3) == "cow") {
      EXPECT_GT(high.x - low.x, 80) << i.name;  // large enough to be a cow
    }
  }
}

}  // namespace
}  // namespace gbl
