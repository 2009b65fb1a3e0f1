// A walled yard in which failures show: surfaces towards all six sides, plain ones and normal-mapped ones, round ones and
// squashed ones, edges before a far wall, and lamps between them. A flat floor alone hides half of the pitfalls.
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

constexpr double kSide = 40;

glm::dmat4 squashed_at(glm::dvec3 place, glm::dvec3 by) { return glm::scale(glm::translate(glm::dmat4(1), place), by); }

void add_ground_and_walls(Scene& scene) {
  const int paving = add(scene, make_tiles(256, 11), {.name = "paving"});
  const int bricks = add(scene, make_bricks(256, 12), {.name = "bricks"});
  const int limewash =
      add(scene, Material{.name = "limewash", .base_colour = {0.8f, 0.78f, 0.72f, 1}, .roughness = 0.9f});
  place(scene, "ground", make_sheet({0, 0, kSide}, {kSide, 0, 0}, {0, 0, -kSide}, 0.125, {10, 10}), paving);
  place(scene, "north wall", make_box({0, 0, 0}, {kSide, 5, 1}, 0.25), bricks);          // faces +Z
  place(scene, "west wall", make_box({0, 0, 1}, {1, 5, kSide}, 0.25), bricks);           // faces +X
  place(scene, "east wall", make_box({kSide - 1, 0, 1}, {kSide, 2, 30}, 0.25), bricks);  // faces -X
  // Without a normal map: these normals point along the axes, to the last bit.
  place(scene, "screen", make_box({8, 0, 34}, {16, 2.8, 35}, 0.25), limewash);  // faces -Z, too
  place(scene, "lintel", make_box({16, 2.4, 34}, {22, 2.8, 35}, 0.25), limewash);
  place(scene, "pier", make_box({21, 0, 34}, {22, 2.4, 35}, 0.25), limewash);
}

void add_things(Scene& scene) {
  const int red = add(scene, Material{.name = "red", .base_colour = {0.8f, 0.2f, 0.1f, 1}, .roughness = 0.3f});
  const int white = add(scene, Material{.name = "white", .roughness = 0.45f});
  const int blue = add(scene, Material{.name = "blue", .base_colour = {0.1f, 0.25f, 0.7f, 1}, .roughness = 0.25f});
  const int box = add(scene, make_box({-1.5, 0, -1.5}, {1.5, 4, 1.5}, 0.5), "box");
  const int ball = add(scene, make_ellipsoid({3, 3, 3}, 32, 16), "ball");
  const int coarse = add(scene, make_lathe(std::array<glm::dvec2, 2>{{{1, 0}, {1, 4}}}, 6), "six-sided column");
  place(scene, "red box", box, red, standing_at({10, 0, 12}));
  place(scene, "white box", box, white, standing_at({28, 0, 20}));
  place(scene, "ball", ball, white, standing_at({20, 3, 24}));
  place(scene, "flat cushion", ball, blue, squashed_at({26, 0.75, 28}, {1, 0.25, 1}));
  place(scene, "egg", ball, red, squashed_at({13, 3, 22}, {0.4, 1, 0.4}));
  place(scene, "column", coarse, blue, standing_at({32, 0, 12}, 20));
}

}  // namespace

Scene build_yard() {
  Scene scene;
  scene.name = "yard";
  add_ground_and_walls(scene);
  add_things(scene);
  scene.bounds = bounds_of(scene);
  scene.light_grid = {.extent = {kSide, kSide}, .height = 3, .pivot = {kSide / 2, kSide / 2}};
  scene.camera = camera_at({22, 9, 46}, 5, -22, 45, 0.5, 200);
  return scene;
}

}  // namespace gbl
