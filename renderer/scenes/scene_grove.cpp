// In the manner of source 4 (an engine blog, parts 30 and 31): a tree trunk and a house with normal maps, a sun, three
// point lights and a sky.
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_house.h"
#include "renderer/scenes/scene_parts.h"
#include "renderer/scenes/scene_plants.h"
#include "renderer/scenes/texture_painting.h"

namespace gbl {
namespace {

constexpr glm::dvec3 kHouse(3.4, 0, -7.2);
constexpr double kHouseYaw = -24;
constexpr glm::dvec3 kTrunk(-2.1, 0, 1.6);
constexpr int kTrees = 22;

// Flat near the middle, hills around.
double ground_height(double x, double z, const TileNoise& noise) {
  const double away = smoothstep(11, 51, std::sqrt(x * x + (z + 4) * (z + 4)));
  return 0.06 * noise.at(x / 32, z / 32, 12) + away * (4.5 + 9 * noise.fractal(x / 160, z / 160, 6, 3));
}

Mesh make_grove_ground(const TileNoise& noise) {
  constexpr int kSide = 120;
  constexpr double kHalf = 80;
  std::vector<double> x, z;
  for (int i = 0; i <= kSide; ++i) {  // closer together in the middle
    const double s = 2.0 * i / kSide - 1;
    x.push_back(kHalf * (0.25 * s + 0.75 * s * s * s));
    z.push_back(x.back() - 4);
  }
  return make_ground(
      x, z, [&noise](double px, double pz) { return ground_height(px, pz, noise); }, 0.35);
}

void add_trees(Scene& scene, const TileNoise& noise, int bark, int leaves) {
  struct Kind {
    int wood, foliage;
  };
  std::vector<Kind> kinds;
  const TreeShape shapes[] = {{.height = 7, .trunk = 2.4, .radius = 0.2, .crown = 2.3, .rounds = 13, .seed = 3},
                              {.height = 5.4, .trunk = 1.6, .radius = 0.16, .crown = 1.9, .rounds = 11, .seed = 4},
                              {.height = 9, .trunk = 2.6, .radius = 0.25, .crown = 2.2, .rounds = 16, .seed = 5}};
  for (const TreeShape& shape : shapes) {
    Tree tree = make_tree(shape);
    const int wood = add(scene, std::move(tree.wood), "tree");
    kinds.push_back({wood, add(scene, std::move(tree.foliage), "crown")});
  }
  Pcg32 rng(14);
  for (int i = 0; i < kTrees; ++i) {  // around the house and behind it, none between it and the camera
    const double angle = glm::radians(-200 + 225.0 * (i + rng.in(0.1, 0.9)) / kTrees), far = rng.in(13, 34);
    const glm::dvec2 p(2 + far * std::cos(angle), -4 + far * std::sin(angle));
    const Kind& kind = kinds[static_cast<size_t>(i) % kinds.size()];
    const double size = rng.in(0.8, 1.25), turn = rng.in(0, 360);
    const glm::dmat4 at = standing_at({p.x, ground_height(p.x, p.y, noise), p.y}, turn, size);
    place(scene, fmt::format("tree {}", i + 1), kind.wood, bark, at);
    place(scene, fmt::format("crown {}", i + 1), kind.foliage, leaves, at);
  }
}

void add_house(Scene& scene, int wood) {
  House house = make_house();
  const glm::dmat4 at = standing_at(kHouse, kHouseYaw);
  const int bricks = add(scene, make_bricks(256, 2), {.name = "bricks"});
  const int tiles = add(scene, make_roof_tiles(256, 3), {.name = "roof tiles"});
  const int panes = add(
      scene,
      {.name = "panes", .base_colour = {0.05f, 0.06f, 0.07f, 1}, .roughness = 0.12f, .emissive = {0.75f, 0.5f, 0.22f}});
  place(scene, "house walls", add(scene, std::move(house.walls), "house walls"), bricks, at);
  place(scene, "house roof", add(scene, std::move(house.roof), "house roof"), tiles, at);
  place(scene, "house wood", add(scene, std::move(house.wood), "house wood"), wood, at);
  place(scene, "house windows", add(scene, std::move(house.panes), "house windows"), panes, at);
}

void add_lights(Scene& scene) {
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = glm::normalize(glm::dvec3(0.62, -0.5, -0.6));
  sun.colour = {0.95, 0.8, 0.6};
  scene.lights.push_back(sun);
  const glm::dmat4 house = standing_at(kHouse, kHouseYaw);
  const auto add_point = [&scene](glm::dvec3 p, double range, glm::dvec3 colour) {
    Light light;
    light.position = p, light.range = range, light.colour = colour;
    scene.lights.push_back(light);
  };
  add_point(glm::dvec3(house * glm::dvec4(0.25, 2.3, 2.7, 1)), 5, {2.0, 1.25, 0.55});  // over the door
  add_point(kTrunk + glm::dvec3(1.35, 0.7, 0.7), 4, {0.7, 1.3, 2.4});  // on the shaded side of the trunk
  add_point({-0.6, 0.7, -4.5}, 5, {2.4, 0.7, 1.3});
}

}  // namespace

Scene build_grove() {
  Scene scene;
  scene.name = "grove";
  const TileNoise noise(6);
  const int grass = add(scene, make_grass(256, 5), {.name = "grass"});
  const int bark = add(scene, make_bark(512, 6), {.name = "bark"});
  const int leaves = add(scene, make_foliage(256, 7), {.name = "leaves"});
  const int wood = add(scene, make_planks(256, 8), {.name = "wood"});
  place(scene, "ground", make_grove_ground(noise), grass);
  constexpr double kRadius = 0.55, kTilesAround = 2;
  const int deep_bark =
      add_relief(scene, make_bark(512, 6), {.name = "deep bark"}, kTilesAround / (glm::two_pi<double>() * kRadius));
  place(scene, "old trunk", add(scene, make_old_trunk(5.5, kRadius, 9), "old trunk"), deep_bark, standing_at(kTrunk));
  add_house(scene, wood);
  add_trees(scene, noise, bark, leaves);
  add_lights(scene);
  scene.bounds = bounds_of(scene);
  scene.light_box = LightBox{{-8, 0.2, -12}, {8, 3, 5}};
  scene.camera = camera_at({0.2, 1.7, 6.4}, 4, 1, 50, 0.1, 400);
  return scene;
}

}  // namespace gbl
