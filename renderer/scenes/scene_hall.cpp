// A hall of columns for hundreds of small lights (source 2's first picture has 1847): normal-mapped surfaces in
// several colours, many edges, and no light that reaches from wall to wall.
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"
#include "renderer/scenes/scene_props.h"

namespace gbl {
namespace {

using Profile = std::vector<glm::dvec2>;

constexpr glm::dvec3 kLow(-20, 0, -8), kHigh(20, 8, 8);
constexpr int kBays = 8;
constexpr double kBay = 5;  // length of one
constexpr double kColumnZ = 4.2, kColumnHeight = 5.4;

struct HallMaterials {
  int floor, stone, flutes, ceiling, carpet, statue;
  std::vector<int> walls;
};

HallMaterials add_materials(Scene& scene) {
  HallMaterials m{};
  m.floor = add(scene, make_tiles(512, 1), {.name = "floor tiles"});
  m.flutes = add(scene, make_flutes(256, 2), {.name = "fluted stone"});
  m.stone = add(scene, make_plaster(256, 3), {.name = "stone", .base_colour = {0.82f, 0.78f, 0.7f, 1}});
  const int panels = add(scene, make_panels(256, 4), {.name = "oak panels", .base_colour = {0.5f, 0.36f, 0.22f, 1}});
  m.ceiling = panels;
  const struct {
    const char* name;
    glm::vec4 colour;
  } kWalls[] = {{"red panels", {0.62f, 0.18f, 0.14f, 1}},
                {"ochre panels", {0.72f, 0.52f, 0.18f, 1}},
                {"green panels", {0.2f, 0.48f, 0.28f, 1}},
                {"blue panels", {0.18f, 0.32f, 0.62f, 1}}};
  for (const auto& w : kWalls) {
    Material wall = scene.materials[panels];
    wall.name = w.name, wall.base_colour = w.colour;
    m.walls.push_back(add(scene, wall));
  }
  Material carpet = scene.materials[m.stone];
  carpet.name = "carpet", carpet.base_colour = {0.42f, 0.05f, 0.07f, 1}, carpet.roughness = 1;
  m.carpet = add(scene, carpet);
  m.statue = add(scene, Material{.name = "polished stone", .base_colour = {0.8f, 0.79f, 0.76f, 1}, .roughness = 0.35f});
  return m;
}

void add_shell(Scene& scene, const HallMaterials& m) {
  const glm::dvec3 size = kHigh - kLow, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  place(scene, "floor", make_sheet(kLow + z, x, -z, 0.25, {40, 16}), m.floor);
  place(scene, "ceiling", make_sheet(kLow + y, x, z, 0.25, {40, 16}), m.ceiling);
  place(scene, "end wall", make_sheet(kLow + x, z, y, 0.25, {16, 8}), m.walls[1]);
  place(scene, "wall behind", make_sheet(kLow + z, -z, y, 0.25, {16, 8}), m.walls[1]);
  // Two wall meshes, one for each side, in a colour per bay.
  const int left = add(scene, make_sheet({0, 0, kLow.z}, {kBay, 0, 0}, y, 0.4, {5, 8}), "left wall");
  const int right = add(scene, make_sheet({kBay, 0, kHigh.z}, {-kBay, 0, 0}, y, 0.4, {5, 8}), "right wall");
  for (int bay = 0; bay < kBays; ++bay) {
    const glm::dmat4 at = standing_at({kLow.x + bay * kBay, 0, 0});
    place(scene, fmt::format("left wall {}", bay + 1), left, m.walls[static_cast<size_t>(bay) % 4], at);
    place(scene, fmt::format("right wall {}", bay + 1), right, m.walls[static_cast<size_t>(bay + 2) % 4], at);
  }
  place(scene, "carpet", make_rounded_box({kLow.x + 0.5, 0, -1.1}, {kHigh.x - 4, 0.03, 1.1}, 0.012, 1, 0.5), m.carpet);
}

// Base and capital of a column, joined in one mesh; the shaft carries the fluted stone.
Mesh make_column_ends() {
  Mesh ends;
  append(ends, make_box({-0.62, 0, -0.62}, {0.62, 0.22, 0.62}, 0.5), glm::dmat4(1));
  append(ends, make_lathe(Profile{{0.6, 0.22}, {0.6, 0.3}, {0.54, 0.38}, {0.5, 0.4}, {0.55, 0.48}, {0.47, 0.56}}, 28),
         glm::dmat4(1), {{0, 0}, {2, 0.3}});
  append(
      ends,
      make_lathe(Profile{{0.4, 4.72}, {0.44, 4.74}, {0.44, 4.8}, {0.41, 4.82}, {0.45, 4.95}, {0.6, 5.12}, {0.64, 5.14}},
                 28),
      glm::dmat4(1), {{0, 0}, {2, 0.3}});
  append(ends, make_box({-0.66, 5.14, -0.66}, {0.66, kColumnHeight, 0.66}, 0.5), glm::dmat4(1));
  return ends;
}

Mesh make_shaft() {  // swells a little, as columns do
  return retiled(make_lathe(Profile{{0.47, 0.55}, {0.475, 1.5}, {0.465, 2.6}, {0.44, 3.8}, {0.405, 4.74}}, 28), {2, 2});
}

// Round arches between the columns of one row, as stones; from column to column along X.
Mesh make_bay_arch() {
  constexpr int kStones = 13;
  constexpr double kInner = 1.85, kOuter = 2.5, kDepth = 0.5;
  Mesh arch;
  for (int i = 0; i < kStones; ++i) {
    std::array<glm::dvec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
      const double angle = glm::pi<double>() * (i + (k & 2 ? 1 : 0)) / kStones;
      const double radius = k & 1 ? kOuter - 0.03 * (i % 2) : kInner + 0.02 * (i % 2);
      const double squash = 0.72;  // lower than a half circle, or it would not fit under the ceiling
      corners[k] = {radius * std::cos(angle), kColumnHeight + radius * squash * std::sin(angle),
                    (k & 4 ? 1 : -1) * (kDepth - 0.02 * (i % 2))};
    }
    append(arch, make_hexahedron(corners, 0.5, {0.13 * i, 0.29 * i}), glm::dmat4(1));
  }
  return arch;
}

void add_columns(Scene& scene, const HallMaterials& m) {
  const int ends = add(scene, make_column_ends(), "column ends"), shaft = add(scene, make_shaft(), "shaft");
  const int arch = add(scene, make_bay_arch(), "arch");
  const int pilaster = add(scene, make_rounded_box({-0.35, 0, -0.22}, {0.35, kHigh.y, 0.22}, 0.05, 2, 0.5), "pilaster");
  const int beam = add(scene, make_rounded_box({-0.3, 7.35, kLow.z}, {0.3, kHigh.y, kHigh.z}, 0.05, 2, 0.5), "beam");
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < kBays + 1; ++i) {
      const double x = kLow.x + i * kBay, z = row ? kColumnZ : -kColumnZ, wall = row ? kHigh.z : kLow.z;
      const std::string which = fmt::format("{} {}", row ? "right" : "left", i + 1);
      if (i > 0 && i < kBays) {
        place(scene, "shaft " + which, shaft, m.flutes, standing_at({x, 0, z}));
        place(scene, "column " + which, ends, m.stone, standing_at({x, 0, z}));
        place(scene, "pilaster " + which, pilaster, m.stone, standing_at({x, 0, wall}));
      }
      if (i < kBays) place(scene, "arch " + which, arch, m.stone, standing_at({x + kBay / 2, 0, z}));
    }
  for (int i = 1; i < kBays; ++i)
    place(scene, fmt::format("beam {}", i), beam, m.stone, standing_at({kLow.x + i * kBay, 0, 0}));
}

void add_statue(Scene& scene, const HallMaterials& m) {
  constexpr double kPlinth = 1.3, kX = 17;
  Mesh plinth;
  append(plinth, make_rounded_box({kX - 1.1, 0, -1.9}, {kX + 1.1, 0.3, 1.9}, 0.06, 2, 0.5), glm::dmat4(1));
  append(plinth, make_rounded_box({kX - 0.8, 0.3, -1.6}, {kX + 0.8, kPlinth, 1.6}, 0.05, 2, 0.5), glm::dmat4(1));
  place(scene, "plinth", plinth, m.stone);
  place(scene, "statue of a cow", add(scene, make_cow(), "cow"), m.statue, standing_at({kX, kPlinth, 0.2}, 115, 0.042));
}

}  // namespace

Scene build_hall() {
  Scene scene;
  scene.name = "hall";
  const HallMaterials m = add_materials(scene);
  add_shell(scene, m);
  add_columns(scene, m);
  add_statue(scene, m);
  LightBox box;
  box.min = kLow + glm::dvec3(0.4, 0.15, 0.4), box.max = kHigh - glm::dvec3(0.4, 0.3, 0.4);
  box.rule = BoxRange::fixed;
  box.range = 1.2;
  box.colour_min = 0.2, box.colour_max = 3;  // further apart than elsewhere: lamps of a colour each
  scene.light_box = box;
  scene.bounds = bounds_of(scene);
  scene.camera = camera_at({-19.4, 2.3, 0}, -90, 4, 55, 0.1, 100);
  return scene;
}

}  // namespace gbl
