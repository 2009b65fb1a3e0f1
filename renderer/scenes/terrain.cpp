// The terrain of source 0 (nclgl tutorial 15): 257x257 heights, 16 apart, under a grid of lights at y = 100. Hills stay
// below the lights; beyond 2000 from the centre ridges close the view. A few things stand where the start camera looks.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/scenes/procedural_texture.h"
#include "renderer/scenes/scene_props.h"

namespace gbl {
namespace {

constexpr int kSide = 257;
constexpr double kSpacing = 16;
constexpr double kExtent = (kSide - 1) * kSpacing;
constexpr glm::dvec2 kCentre(2056, 2056);  // of the lights: half of 257 * 16, as source 0 has it
constexpr double kHillsRadius = 2000, kHillsHeight = 80, kHighest = 319;
constexpr double kUvPerUnit = 1.0 / 256;   // source 0: its textures repeat every 16 cells
constexpr glm::dvec2 kMeadow(2350, 2880);  // gentler ground, or legs would sink where things stand
constexpr double kMeadowHeight = 26, kMeadowRadius = 420, kMeadowFlatness = 0.88;

class HeightField {
 public:
  HeightField();
  double at(int x, int z) const { return heights_[z * kSide + x]; }
  double at(glm::dvec2 xz) const;  // between the vertices: bilinear
  glm::dvec3 normal(int x, int z) const;

 private:
  std::vector<double> heights_;
};

glm::dvec2 place_of(int x, int z) { return glm::dvec2(x, z) * kSpacing; }

double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// 0 on the hills, 1 far outside.
double outside(glm::dvec2 p) { return smooth((glm::distance(p, kCentre) - kHillsRadius) / 1000); }

std::vector<double> hills() {
  const TileNoise noise(2015);
  std::vector<double> h;
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 uv = place_of(x, z) / kExtent;
      // Bent by a slower noise: straight noise shows its lattice as rows of equal hills.
      const glm::dvec2 bend(noise.at(uv.y, uv.x, 3), noise.at(uv.x, uv.y, 3));
      const glm::dvec2 p = uv + bend * 0.035;
      h.push_back(noise.fractal(p.x, p.y, 8, 5, 0.42));
    }
  const auto [low, high] = std::minmax_element(h.begin(), h.end());
  const double from = *low, range = *high - *low;
  // Noise is mostly near its middle: steepened there, so that hills and hollows tell in the light.
  for (double& y : h) y = kHillsHeight * smooth((y - from) / range);
  return h;
}

HeightField::HeightField() : heights_(hills()) {
  const TileNoise noise(64);
  std::vector<double> ridges(heights_.size());
  double scale = kHighest;  // the largest that lets no vertex rise above kHighest: one vertex reaches it exactly
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 p = place_of(x, z), uv = p / kExtent;
      const int i = z * kSide + x;
      const double near = smooth(1 - glm::distance(p, kMeadow) / kMeadowRadius) * kMeadowFlatness;
      heights_[i] = heights_[i] * (1 - near) + kMeadowHeight * near;
      ridges[i] = outside(p) * (0.5 + noise.ridged(uv.x, uv.y, 7, 3));
      if (ridges[i] > 0) scale = std::min(scale, (kHighest - heights_[i]) / ridges[i]);
    }
  for (size_t i = 0; i < heights_.size(); ++i) heights_[i] = std::min(heights_[i] + ridges[i] * scale, kHighest);
}

double HeightField::at(glm::dvec2 xz) const {
  const glm::dvec2 cell = glm::clamp(glm::floor(xz / kSpacing), 0.0, kSide - 2.0);
  const glm::dvec2 t = xz / kSpacing - cell;
  const int x = static_cast<int>(cell.x), z = static_cast<int>(cell.y);
  return glm::mix(glm::mix(at(x, z), at(x + 1, z), t.x), glm::mix(at(x, z + 1), at(x + 1, z + 1), t.x), t.y);
}

glm::dvec3 HeightField::normal(int x, int z) const {
  const int left = std::max(x - 1, 0), right = std::min(x + 1, kSide - 1);
  const int back = std::max(z - 1, 0), front = std::min(z + 1, kSide - 1);
  const double along_x = (at(right, z) - at(left, z)) / ((right - left) * kSpacing);
  const double along_z = (at(x, front) - at(x, back)) / ((front - back) * kSpacing);
  return glm::normalize(glm::dvec3(-along_x, 1, -along_z));
}

Mesh make_ground(const HeightField& field) {
  Mesh mesh;
  mesh.name = "ground";
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 p = place_of(x, z);
      const glm::dvec3 n = field.normal(x, z);
      const glm::dvec3 tangent = glm::normalize(glm::dvec3(n.y, -n.x, 0));  // +X bent into the surface
      mesh.vertices.push_back({.position = glm::dvec3(p.x, field.at(x, z), p.y),
                               .normal = n,
                               .tangent = glm::dvec4(tangent, 1),
                               .uv = p * kUvPerUnit});
    }
  for (uint32_t z = 0; z + 1 < kSide; ++z)
    for (uint32_t x = 0; x + 1 < kSide; ++x) {
      const uint32_t a = z * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  return mesh;
}

// Where a mesh stands: turned by yaw about its origin and let down until every foot (whatever is within 1 of its
// lowest point) is at least `sunk` below the ground, so that no gap shows.
glm::dmat4 standing(const Mesh& mesh, const HeightField& field, glm::dvec2 xz, double yaw_deg, double sunk) {
  constexpr double kFoot = 1;
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(yaw_deg), {0, 1, 0});
  double lowest = 1e9, y = 1e9;
  for (const Vertex& v : mesh.vertices) lowest = std::min(lowest, static_cast<double>(v.position.y));
  for (const Vertex& v : mesh.vertices) {
    if (v.position.y > lowest + kFoot) continue;
    const glm::dvec3 p(turn * glm::dvec4(glm::dvec3(v.position), 1));
    y = std::min(y, field.at(xz + glm::dvec2(p.x, p.z)) - p.y - sunk);
  }
  return glm::translate(glm::dmat4(1), {xz.x, y, xz.y}) * turn;
}

enum MaterialIndex { ground_material, stone_material, paint_material };

void add_materials(Scene& scene) {
  GroundTextures ground = make_ground_textures(512, 15);
  scene.textures = {std::move(ground.albedo), std::move(ground.normal), std::move(ground.wetness),
                    make_stone_albedo(256, 3), make_paint(256, 4)};
  scene.materials = {{.name = "ground", .base_colour_texture = {0}, .normal_texture = {1}, .roughness_texture = {2}},
                     {.name = "stone", .roughness = 0.8f, .base_colour_texture = {3}, .normal_texture = {1}},
                     {.name = "paint", .roughness = 0.55f, .base_colour_texture = {4}}};
}

void add_things(Scene& scene, const HeightField& field) {
  const auto mesh = [&scene](Mesh m, const char* name) {
    m.name = name;
    scene.meshes.push_back(std::move(m));
    return static_cast<int>(scene.meshes.size()) - 1;
  };
  const int arch = mesh(make_arch(), "arch"), wall = mesh(make_wall(), "wall");
  const int lamp = mesh(make_lamp_post(), "lamp-post"), cow = mesh(make_cow(), "cow");
  const int large = mesh(make_boulder({34, 26, 30}, 0.16, 5, 1.0 / 256), "large boulder");
  const int small = mesh(make_boulder({17, 13, 15}, 0.18, 6, 1.0 / 256), "small boulder");
  struct Thing {
    const char* name;
    int mesh, material;
    glm::dvec2 xz;
    double yaw_deg;
    double sunk = 0.6;  // round things lie deeper, or they balance on a point
  };
  const Thing things[] = {
      {"arch", arch, stone_material, {2262, 2850}, 0},
      {"wall", wall, stone_material, {2650, 2770}, 0},
      {"lamp-post", lamp, paint_material, {2395, 2905}, 0},
      {"cow 1", cow, paint_material, {2318, 2940}, 25},
      {"cow 2", cow, paint_material, {2455, 2800}, 200},
      {"boulder 1", large, stone_material, {2590, 2860}, 20, 9},
      {"boulder 2", small, stone_material, {2548, 2895}, 75, 5},
      {"boulder 3", large, stone_material, {2425, 2640}, 130, 9},
  };
  for (const Thing& t : things)
    scene.instances.push_back(
        {t.name, t.mesh, t.material, standing(scene.meshes[t.mesh], field, t.xz, t.yaw_deg, t.sunk)});
}

}  // namespace

Scene build_terrain() {
  Scene scene;
  scene.name = "terrain";
  const HeightField field;
  add_materials(scene);
  scene.meshes.push_back(make_ground(field));
  scene.instances.push_back({"ground", 0, ground_material, glm::dmat4(1)});
  add_things(scene, field);
  scene.bounds = bounds_of(scene);
  scene.camera.position = {2470, 340, 3320};
  scene.camera.orientation = orientation_from_yaw_pitch(7, -23);
  scene.camera.near = 1;
  scene.camera.far = 10000;
  return scene;
}

}  // namespace gbl
