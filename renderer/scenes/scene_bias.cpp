// A stage for shadows: what a bias must not lose (stairs, thin boards, things that stand on the ground), where it is too
// small (slopes that the light grazes), and leaves that are cut out of cards. A sun, a lamp and a spot.
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"
#include "renderer/scenes/texture_painting.h"

namespace gbl {
namespace {

constexpr glm::dvec3 kTree(-4.9, 0, 2.6);

// Leaves of three by three pointed ellipses a tile; alpha is 255 on them and 0 beside.
Texture make_leaves(int size) {
  const auto leaf = [size](int x, int y) {
    const Cell c = cell_of((x + 0.5) / size, (y + 0.5) / size, 3, 3);
    const double across = (c.x - 0.5) / 0.3, along = (c.y - 0.5) / 0.48;
    return 1 - along * along - std::abs(across);  // above 0 within
  };
  Texture t = make_texture("leaves", size, [&](int x, int y) {
    return mixed({52, 92, 30}, {128, 158, 62}, smoothstep(0, 1, leaf(x, y)));
  });
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) t.rgba[4 * (static_cast<size_t>(y) * size + x) + 3] = leaf(x, y) > 0 ? 255 : 0;
  return t;
}

// Right-angled, rising along +X.
Mesh make_ramp(double run, double rise, double width) {
  const glm::dvec3 low(0), high(run, rise, width);
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<size_t>(i)] = {i & 1 ? high.x : low.x, (i & 2) && (i & 1) ? high.y : 0.01 * (i & 2),
                                       i & 4 ? high.z : low.z};
  return make_hexahedron(corners, 0.5);
}

void add_stage(Scene& scene) {
  const int paving = add(scene, make_tiles(128, 21), {.name = "paving"});
  const int limewash =
      add(scene, Material{.name = "limewash", .base_colour = {0.8f, 0.78f, 0.72f, 1}, .roughness = 0.9f});
  place(scene, "ground", make_sheet({-10, 0, 8}, {20, 0, 0}, {0, 0, -14}, 0.25, {10, 7}), paving);
  place(scene, "back wall", make_box({-10, 0, -6.3}, {10, 4.5, -6}, 0.25), limewash);
}

void add_stairs(Scene& scene) {
  const int stone = add(scene, Material{.name = "stone", .base_colour = {0.55f, 0.52f, 0.5f, 1}, .roughness = 0.7f});
  constexpr int kSteps = 8;
  for (int i = 0; i < kSteps; ++i) {
    const double z = -1.2 - 0.4 * i;
    place(scene, fmt::format("step {}", i + 1).c_str(), make_box({4, 0, z - 0.4}, {7.4, 0.22 * (i + 1), z}, 0.5),
          stone);
  }
}

// From as thick as a wall to as thin as a sheet.
void add_boards(Scene& scene) {
  const int wood = add(scene, make_planks(128, 22), {.name = "boards"});
  double x = -3.6;
  for (const double thick : {0.3, 0.1, 0.03, 0.01, 0.003}) {
    place(scene, fmt::format("board {} thick", thick).c_str(), make_box({x, 0, -3.2}, {x + thick, 1.9, -1.4}, 0.5),
          wood);
    x += 1.35;
  }
}

void add_slopes(Scene& scene) {
  const int clay = add(scene, Material{.name = "clay", .base_colour = {0.62f, 0.36f, 0.26f, 1}, .roughness = 0.8f});
  double x = -3.8;
  for (const double degrees : {10.0, 25.0, 40.0, 55.0, 70.0}) {
    const double run = 1.5 * std::cos(glm::radians(degrees)), rise = 1.5 * std::sin(glm::radians(degrees));
    const int ramp = add(scene, make_ramp(run, rise, 1.1), "ramp");
    place(scene, fmt::format("slope of {:.0f} degrees", degrees), ramp, clay, standing_at({x, 0, 1.4}));
    x += run + 0.55;
  }
}

void add_tree(Scene& scene) {
  const int bark = add(scene, make_bark(128, 23), {.name = "bark"});
  Material leaf{.name = "leaves", .roughness = 0.8f};
  leaf.base_colour_texture.texture = add(scene, make_leaves(128));
  leaf.alpha_mode = AlphaMode::mask;
  leaf.double_sided = true;
  const int leaves = add(scene, leaf);
  const Mesh trunk = make_lathe(std::array<glm::dvec2, 3>{{{0.22, -0.1}, {0.14, 1.6}, {0.03, 3.4}}}, 12);
  place(scene, "trunk", add(scene, trunk, "trunk"), bark, standing_at(kTree));
  const Mesh card = make_sheet({-0.75, -0.75, 0}, {1.5, 0, 0}, {0, 1.5, 0}, 1 / 1.5);
  Mesh crown;
  Pcg32 random(24);
  for (int i = 0; i < 16; ++i) {
    const double z = random.in(-1, 1), y = random.in(2.1, 3.5), x = random.in(-1, 1);
    const double tilt = random.in(-1.2, 0.4), turn = random.in(0, 360);
    const glm::dmat4 turned = glm::rotate(standing_at(kTree + glm::dvec3(x, y, z), turn), tilt, {1, 0, 0});
    append(crown, card, turned);
  }
  place(scene, "crown", std::move(crown), leaves);
}

// With a back, which would stand before whoever looks from behind its plane.
void add_standing_mirror(Scene& scene) {
  const int silver =
      add(scene, Material{.name = "silver", .base_colour = {0.9f, 0.92f, 0.93f, 1}, .roughness = 0.04f, .metal = 1});
  const int back =
      add(scene, Material{.name = "mirror's back", .base_colour = {0.3f, 0.2f, 0.14f, 1}, .roughness = 0.8f});
  place(scene, "mirror", make_sheet({7.75, 0.15, -3.398}, {1.9, 0, 0}, {0, 2.5, 0}, 0.5), silver);
  place(scene, "mirror's back", make_box({7.7, 0, -3.5}, {9.7, 2.7, -3.4}, 0.5), back);
}

void add_lights(Scene& scene) {
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = glm::normalize(glm::dvec3(0.6, -0.55, -0.45));
  sun.colour = {1.1, 1.0, 0.85};
  Light lamp;
  lamp.position = {0.9, 1.4, -1.7}, lamp.range = 9, lamp.colour = {1.6, 1.1, 0.6};
  Light spot;
  spot.kind = LightKind::spot;
  spot.position = {8.5, 4.2, 3.5}, spot.range = 14, spot.colour = {0.8, 1.3, 2.2};
  spot.direction = glm::normalize(glm::dvec3(-3, -3.6, -5.5));
  spot.inner_cos = std::cos(glm::radians(20.0)), spot.outer_cos = std::cos(glm::radians(30.0));
  scene.lights = {sun, lamp, spot};
}

}  // namespace

Scene build_bias() {
  Scene scene;
  scene.name = "bias";
  add_stage(scene);
  add_stairs(scene);
  add_boards(scene);
  add_slopes(scene);
  add_tree(scene);
  add_standing_mirror(scene);
  add_lights(scene);
  scene.bounds = bounds_of(scene);
  scene.light_box = LightBox{{-8, 0.3, -5}, {8, 3.5, 5}};
  scene.camera = camera_at({0.2, 3.4, 9.6}, 0, -13, 48, 0.1, 100);
  return scene;
}

}  // namespace gbl
