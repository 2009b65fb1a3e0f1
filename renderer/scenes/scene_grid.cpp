// Source 2's scene (LearnOpenGL, "Deferred Shading"): nine backpacks on a grid under small lights that are spread at
// random in a box. Places, scale, camera and lights are those of its public program.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

constexpr double kUvPerUnit = 1.0 / 3;  // no part is larger than 3, so each shows less than one piece of cloth

UvPart cut_from(Cloth cloth) { return {cloth_uv(cloth), glm::dvec2(kClothUv)}; }

void add_block(Mesh& to, glm::dvec3 low, glm::dvec3 high, double radius, Cloth cloth) {
  append(to, make_rounded_box(low, high, radius, 3, kUvPerUnit), glm::dmat4(1), cut_from(cloth));
}

// Turned about X: it lies from left to right.
void add_lying(Mesh& to, std::span<const glm::dvec2> profile, glm::dvec3 centre, Cloth cloth) {
  const glm::dmat4 place = glm::translate(glm::dmat4(1), centre);
  append(to, make_lathe(profile, 24), glm::rotate(place, -glm::half_pi<double>(), {0, 0, 1}), cut_from(cloth));
}

void add_bag(Mesh& bag) {
  add_block(bag, {-1, -1.6, -0.5}, {1, 1.2, 0.45}, 0.34, Cloth::canvas);
  add_block(bag, {-1.06, 0.8, -0.55}, {1.06, 1.42, 0.6}, 0.26, Cloth::canvas);      // lid
  add_block(bag, {-0.92, 0.3, 0.36}, {0.92, 1.1, 0.6}, 0.1, Cloth::canvas);         // its flap
  add_block(bag, {-0.94, 0.24, 0.34}, {0.94, 0.36, 0.62}, 0.05, Cloth::leather);    // and the hem
  add_block(bag, {-0.72, -1.42, 0.3}, {0.72, -0.1, 0.84}, 0.2, Cloth::canvas);      // front pocket
  add_block(bag, {-0.76, -0.42, 0.4}, {0.76, -0.02, 0.9}, 0.12, Cloth::leather);    // its flap
  add_block(bag, {-1.02, -1.64, -0.52}, {1.02, -1.3, 0.47}, 0.16, Cloth::leather);  // bottom
  for (double side : {-1.0, 1.0}) {
    const double x = side * 1.08;
    add_block(bag, {x - 0.24, -1.35, -0.32}, {x + 0.24, -0.2, 0.32}, 0.18, Cloth::canvas);
    add_block(bag, {x - 0.27, -0.42, -0.35}, {x + 0.27, -0.14, 0.35}, 0.1, Cloth::leather);
  }
}

void add_straps(Mesh& bag) {
  for (double x : {-0.46, 0.46}) {
    add_block(bag, {x - 0.09, -0.3, 0.56}, {x + 0.09, 1.3, 0.67}, 0.05, Cloth::leather);
    add_block(bag, {x - 0.09, 1.3, -0.4}, {x + 0.09, 1.46, 0.6}, 0.05, Cloth::leather);
    add_block(bag, {x - 0.15, -0.02, 0.64}, {x + 0.15, 0.22, 0.72}, 0.035, Cloth::brass);  // buckle
    add_block(bag, {x - 0.08, 0.04, 0.68}, {x + 0.08, 0.16, 0.745}, 0.03, Cloth::leather);
  }
  add_block(bag, {-0.1, -0.62, 0.82}, {0.1, -0.3, 0.93}, 0.05, Cloth::leather);
  add_block(bag, {-0.14, -0.58, 0.86}, {0.14, -0.44, 0.95}, 0.04, Cloth::brass);
  for (double side : {-1.0, 1.0}) {  // over the shoulders
    const std::vector<glm::dvec3> path = {{side * 0.4, 1.2, -0.5},    {side * 0.48, 1.15, -0.75},
                                          {side * 0.58, 0.75, -0.95}, {side * 0.64, 0.1, -1},
                                          {side * 0.7, -0.6, -0.92},  {side * 0.8, -1.2, -0.5}};
    append(bag, make_tube(path, 0.1, 10), glm::dmat4(1), cut_from(Cloth::leather));
  }
  const std::vector<glm::dvec3> handle = {
      {-0.3, 1.35, -0.42}, {-0.28, 1.62, -0.56}, {0, 1.7, -0.6}, {0.28, 1.62, -0.56}, {0.3, 1.35, -0.42}};
  append(bag, make_tube(handle, 0.06, 8), glm::dmat4(1), cut_from(Cloth::leather));
}

void add_roll_and_cup(Mesh& bag) {
  // The ends show the layers of the rolled blanket.
  const std::vector<glm::dvec2> roll = {{0, -1.3},    {0.1, -1.28}, {0.14, -1.32}, {0.24, -1.29}, {0.28, -1.33},
                                        {0.36, -1.3}, {0.4, -1.24}, {0.4, 1.24},   {0.36, 1.3},   {0.28, 1.33},
                                        {0.24, 1.29}, {0.14, 1.32}, {0.1, 1.28},   {0, 1.3}};
  constexpr glm::dvec3 kRoll(0, 1.8, 0.02);
  add_lying(bag, roll, kRoll, Cloth::wool);
  const std::vector<glm::dvec2> ring = {{0.38, -0.09}, {0.44, -0.08}, {0.44, 0.08}, {0.38, 0.09}};
  for (double x : {-0.46, 0.46}) add_lying(bag, ring, kRoll + glm::dvec3(x, 0, 0), Cloth::leather);
  const std::vector<glm::dvec2> cup = {{0, 0},      {0.19, 0},     {0.21, 0.03}, {0.23, 0.4},
                                       {0.25, 0.4}, {0.22, 0.385}, {0.19, 0.05}, {0, 0.04}};
  append(bag, make_lathe(cup, 20), glm::translate(glm::dmat4(1), {1.16, 0.02, 0.3}), cut_from(Cloth::brass));
  const std::vector<glm::dvec3> grip = {{1.34, 0.36, 0.42}, {1.46, 0.36, 0.5}, {1.47, 0.2, 0.5}, {1.36, 0.1, 0.42}};
  append(bag, make_tube(grip, 0.03, 8), glm::dmat4(1), cut_from(Cloth::brass));
}

Mesh make_backpack() {
  Mesh bag, centred;
  add_bag(bag);
  add_straps(bag);
  add_roll_and_cup(bag);
  append(centred, bag, glm::translate(glm::dmat4(1), {0, -0.28, 0}));
  return centred;
}

}  // namespace

Scene build_grid() {
  Scene scene;
  scene.name = "grid";
  const int cloth = add(scene, make_cloth(512, 8), {.name = "cloth"});
  const int backpack = add(scene, make_backpack(), "backpack");
  int number = 0;
  for (double z : {-3.0, 0.0, 3.0})
    for (double x : {-3.0, 0.0, 3.0})
      place(scene, "backpack " + std::to_string(++number), backpack, cloth, standing_at({x, -0.5, z}, 0, 0.5));
  LightBox box;
  box.min = {-3, -4, -3}, box.max = {3, 2, 3};
  box.rule = BoxRange::quadratic;
  box.colour_min = 0.5, box.colour_max = 1;
  scene.light_box = box;
  scene.bounds = bounds_of(scene);
  scene.camera = camera_at({0, 0, 5}, 0, 0, 45, 0.1, 100);
  return scene;
}

}  // namespace gbl
