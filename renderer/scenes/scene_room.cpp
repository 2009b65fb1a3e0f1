// In the manner of source 1 (tutorial 9, deferred rendering with an accumulation buffer): a closed room whose surfaces
// reflect, shine and let light through, under a point and a spot light. Nothing is reflected here but the lights
// themselves, so metals are dim where no highlight falls.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

using Profile = std::vector<glm::dvec2>;

constexpr glm::dvec3 kLow(-4, 0, -3), kHigh(4, 3.2, 3);
constexpr glm::dvec3 kBulb(-0.9, 1.95, -0.6), kSpot(2.3, 3.0, 0.4), kSpotTarget(0.55, 0.9, -1.2);
constexpr double kTableTop = 0.78;
constexpr double kBricksPerUnit = 1, kPlanksPerUnit = 0.6;  // tiles of their textures

// A curve through the points (Catmull and Rom 1974), four pieces between two of them.
Profile curved(const Profile& points) {
  Profile curve;
  for (size_t k = 0; k + 1 < points.size(); ++k) {
    const glm::dvec2 a = points[k > 0 ? k - 1 : 0], b = points[k], c = points[k + 1];
    const glm::dvec2 d = points[std::min(k + 2, points.size() - 1)];
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double t = 0.25 * quarter;
      curve.push_back(b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a))));
    }
  }
  curve.push_back(points.back());
  return curve;
}

struct RoomMaterials {
  int bricks, ceiling, wall, floor, wood, mirror, chrome, glass, iron, ceramic, sign, bulb;
};

RoomMaterials add_materials(Scene& scene) {
  RoomMaterials m{};
  m.bricks = add_relief(scene, make_bricks(256, 1), {.name = "bricks"}, kBricksPerUnit, 3);
  m.ceiling = add(scene, make_plaster(256, 2), {.name = "ceiling plaster", .base_colour = {0.62f, 0.6f, 0.57f, 1}});
  m.floor = add_relief(scene, make_planks(256, 3), {.name = "floorboards"}, kPlanksPerUnit);
  Material wall = scene.materials[m.ceiling], wood = scene.materials[m.floor];
  wall.name = "painted plaster", wall.base_colour = {0.42f, 0.52f, 0.55f, 1};
  wood.height_texture = {}, wood.height_depth = 0;
  wood.name = "dark wood", wood.base_colour = {0.55f, 0.42f, 0.34f, 1}, wood.normal_scale = 0.4f;
  m.wall = add(scene, wall);
  m.wood = add(scene, wood);
  m.mirror = add(scene, {.name = "mirror", .base_colour = {0.92f, 0.94f, 0.95f, 1}, .roughness = 0.03f, .metal = 1});
  m.chrome = add(scene, {.name = "chrome", .base_colour = {0.78f, 0.78f, 0.8f, 1}, .roughness = 0.16f, .metal = 1});
  m.glass = add(scene, {.name = "glass",
                        .base_colour = {0.55f, 0.85f, 0.9f, 0.3f},
                        .roughness = 0.06f,
                        .alpha_mode = AlphaMode::blend,
                        .transmission = 1});
  m.iron = add(scene, {.name = "black iron", .base_colour = {0.03f, 0.03f, 0.035f, 1}, .roughness = 0.4f});
  m.ceramic = add(scene, {.name = "glazed ceramic", .base_colour = {0.05f, 0.28f, 0.3f, 1}, .roughness = 0.2f});
  m.sign = add(
      scene, {.name = "sign", .base_colour = {0.02f, 0.02f, 0.02f, 1}, .roughness = 0.9f, .emissive = glm::vec3(1.4f)});
  scene.materials[m.sign].emissive_texture = {add(scene, make_sign("DEFERRED", {255, 92, 120}))};
  m.bulb = add(scene, {.name = "bulb", .base_colour = {1, 1, 1, 1}, .emissive = {1.6f, 1.3f, 0.9f}});
  return m;
}

void add_shell(Scene& scene, const RoomMaterials& m) {
  const glm::dvec3 size = kHigh - kLow;
  const glm::dvec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  place(scene, "brick wall", make_sheet(kLow, x, y, kBricksPerUnit, {8, 3}), m.bricks);
  place(scene, "mirror-side wall", make_sheet(kLow + z, -z, y, 0.5, {6, 3}), m.wall);
  place(scene, "right wall", make_sheet(kLow + x, z, y, 0.5, {6, 3}), m.wall);
  place(scene, "wall behind", make_sheet(kLow + x + z, -x, y, 0.5, {8, 3}), m.wall);
  place(scene, "floor", make_sheet(kLow + z, x, -z, kPlanksPerUnit, {8, 6}), m.floor);
  place(scene, "ceiling", make_sheet(kLow + y, x, z, 0.5, {8, 6}), m.ceiling);
  Mesh skirting;
  append(skirting, make_box({kLow.x, 0, kLow.z}, {kHigh.x, 0.12, kLow.z + 0.03}, 0.6), glm::dmat4(1));
  append(skirting, make_box({kLow.x, 0, kLow.z}, {kLow.x + 0.03, 0.12, kHigh.z}, 0.6), glm::dmat4(1));
  append(skirting, make_box({kHigh.x - 0.03, 0, kLow.z}, {kHigh.x, 0.12, kHigh.z}, 0.6), glm::dmat4(1));
  place(scene, "skirting", skirting, m.wood);
}

void add_mirror(Scene& scene, const RoomMaterials& m) {
  const double x = kLow.x, low = 0.35, high = 2.75, back = -2.5, front = 1.7, edge = 0.14;
  place(scene, "mirror", make_sheet({x + 0.04, low, front}, {0, 0, back - front}, {0, high - low, 0}, 1), m.mirror);
  Mesh frame;
  const auto bar = [&frame, x](glm::dvec2 from, glm::dvec2 to) {  // y, z
    append(frame, make_rounded_box({x, from.x, from.y}, {x + 0.09, to.x, to.y}, 0.03, 2, 0.6), glm::dmat4(1));
  };
  bar({low - edge, back - edge}, {low, front + edge});
  bar({high, back - edge}, {high + edge, front + edge});
  bar({low, back - edge}, {high, back});
  bar({low, front}, {high, front + edge});
  place(scene, "mirror frame", frame, m.wood);
}

void add_table(Scene& scene, const RoomMaterials& m) {
  Mesh table;
  append(table, make_rounded_box({-1.5, kTableTop - 0.07, -1.75}, {1.5, kTableTop, -0.75}, 0.03, 3, 0.6),
         glm::dmat4(1));
  for (double x : {-1.36, 1.36})
    for (double z : {-1.63, -0.87})
      append(table, make_lathe(Profile{{0.045, 0}, {0.05, 0.1}, {0.035, 0.4}, {0.06, 0.72}}, 12),
             glm::translate(glm::dmat4(1), {x, 0, z}));
  place(scene, "table", table, m.wood);

  const int ball = add(scene, make_ellipsoid(glm::dvec3(1), 48, 32), "ball");
  const int ring =
      add(scene, make_lathe(Profile{{0.16, 0}, {0.2, 0}, {0.19, 0.06}, {0.15, 0.06}, {0.16, 0}}, 32), "ring");
  const glm::dvec3 glass(-0.55, kTableTop, -1.15), chrome(0.5, kTableTop, -1.25);
  place(scene, "glass ball", ball, m.glass, standing_at(glass + glm::dvec3(0, 0.36, 0), 0, 0.34));
  place(scene, "chrome ball", ball, m.chrome, standing_at(chrome + glm::dvec3(0, 0.38, 0), 0, 0.36));
  place(scene, "stand of the glass ball", ring, m.iron, standing_at(glass));
  place(scene, "stand of the chrome ball", ring, m.iron, standing_at(chrome));
  Profile vase = {{0, 0}, {0.11, 0}};
  const Profile belly =
      curved({{0.11, 0}, {0.13, 0.02}, {0.2, 0.15}, {0.185, 0.27}, {0.1, 0.4}, {0.07, 0.5}, {0.11, 0.58}});
  vase.insert(vase.end(), belly.begin() + 1, belly.end());
  vase.insert(vase.end(), {{0.1, 0.58}, {0.05, 0.48}, {0, 0.46}});  // into its mouth
  const int pot = add(scene, make_lathe(vase, 32), "vase");
  place(scene, "vase", pot, m.ceramic, standing_at({1.18, kTableTop, -1.0}));
  place(scene, "floor vase", pot, m.ceramic, standing_at({2.5, 0, -2.45}, 0, 2));
}

void add_lamps(Scene& scene, const RoomMaterials& m) {
  place(scene, "bulb", add(scene, make_ellipsoid({0.07, 0.09, 0.07}, 20, 14), "bulb"), m.bulb, standing_at(kBulb));
  Mesh pendant;
  append(pendant, make_lathe(Profile{{0.3, -0.04}, {0.22, 0.1}, {0.08, 0.2}, {0.03, 0.26}, {0, 0.27}}, 32),
         glm::dmat4(1));
  // Its inside: from top to bottom, so that it faces the axis.
  append(pendant, make_lathe(Profile{{0, 0.25}, {0.07, 0.18}, {0.2, 0.09}, {0.28, -0.04}}, 32), glm::dmat4(1));
  append(pendant, make_lathe(Profile{{0.008, 0.25}, {0.008, kHigh.y - kBulb.y}}, 8), glm::dmat4(1));
  place(scene, "pendant", add(scene, std::move(pendant), "pendant"), m.iron, standing_at(kBulb));
  Mesh spot;
  const glm::dvec3 aim = glm::normalize(kSpotTarget - kSpot);
  append(spot,
         make_lathe(Profile{{0, -0.16}, {0.07, -0.15}, {0.09, 0.04}, {0.075, 0.04}, {0.05, -0.05}, {0, -0.06}}, 24),
         pointing(kSpot - aim * 0.05, kSpot + aim));
  append(spot, make_box({kSpot.x - 0.015, kSpot.y, kSpot.z - 0.015}, {kSpot.x + 0.015, kHigh.y, kSpot.z + 0.015}, 1),
         glm::dmat4(1));
  place(scene, "spot lamp", spot, m.iron);
  const double left = -1.1, bottom = 2.12, width = 2.72, height = 0.5;
  place(scene, "sign board",
        make_rounded_box({left - 0.06, bottom - 0.06, -3}, {left + width + 0.06, bottom + height + 0.06, -2.93}, 0.02,
                         2, 1),
        m.iron);
  place(scene, "sign", make_sheet({left, bottom, -2.92}, {width, 0, 0}, {0, height, 0}, 1), m.sign);
  for (Vertex& v : scene.meshes.back().vertices)  // the whole texture, once
    v.uv = {(v.position.x - left) / width, 1 - (v.position.y - bottom) / height};
}

void add_lights(Scene& scene) {
  Light bulb, spot, glow;
  // Just below the glass, which else would hide its own light.
  bulb.position = kBulb - glm::dvec3(0, 0.105, 0), bulb.colour = {4.2, 3.4, 2.4}, bulb.range = 9;
  spot.kind = LightKind::spot;
  spot.position = kSpot, spot.direction = glm::normalize(kSpotTarget - kSpot);
  spot.colour = {13, 13.5, 14}, spot.range = 8;
  spot.inner_cos = std::cos(glm::radians(14.0)), spot.outer_cos = std::cos(glm::radians(23.0));
  glow.position = {0.25, 2.25, -2.3}, glow.colour = {0.6, 0.16, 0.22}, glow.range = 3;  // of the sign
  scene.lights = {bulb, spot, glow};
}

}  // namespace

Scene build_room() {
  Scene scene;
  scene.name = "room";
  const RoomMaterials m = add_materials(scene);
  add_shell(scene, m);
  add_mirror(scene, m);
  add_table(scene, m);
  add_lamps(scene, m);
  add_lights(scene);
  scene.bounds = bounds_of(scene);
  scene.light_box = LightBox{kLow + 0.3, kHigh - 0.3};
  scene.camera = camera_at({2.6, 1.65, 2.75}, 33, -8, 55, 0.05, 50);
  return scene;
}

}  // namespace gbl
