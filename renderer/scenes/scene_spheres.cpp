// In the manner of source 3 (tutorial 08.2, deferred renderer): many instances of one sphere, materials that differ in
// colour and shininess, and all three kinds of light. Columns go from rough to smooth, so each row of a colour shows
// what its highlights do.
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

constexpr int kColumns = 10, kRows = 10, kLayers = 3;
constexpr double kSpacing = 1.5, kRadius = 0.52;

constexpr glm::dvec3 kColours[] = {{0.78, 0.12, 0.10}, {0.88, 0.42, 0.08}, {0.82, 0.70, 0.12}, {0.22, 0.58, 0.16},
                                   {0.10, 0.48, 0.62}, {0.16, 0.24, 0.72}, {0.52, 0.20, 0.62}, {0.74, 0.74, 0.72}};
constexpr const char* kNames[] = {"red", "orange", "yellow", "green", "turquoise", "blue", "violet", "white"};
constexpr int kColourCount = 8, kFinishes = 5;

void add_materials(Scene& scene) {
  constexpr const char* kFinish[kFinishes] = {"chalk", "matte", "satin", "gloss", "polish"};
  constexpr float kRoughness[kFinishes] = {0.95f, 0.7f, 0.5f, 0.34f, 0.22f};
  for (int c = 0; c < kColourCount; ++c)
    for (int f = 0; f < kFinishes; ++f)
      add(scene, Material{.name = fmt::format("{} {}", kNames[c], kFinish[f]),
                          .base_colour = glm::vec4(glm::vec3(kColours[c]), 1),
                          .roughness = kRoughness[f]});
}

// A block whose upper layers recede: stairs towards the camera, so that the inside is seen, too.
void add_spheres(Scene& scene) {
  const int sphere = add(scene, make_ellipsoid(glm::dvec3(kRadius), 32, 20), "sphere");
  for (int layer = 0; layer < kLayers; ++layer)
    for (int row = 0; row < kRows - 3 * layer; ++row)
      for (int column = 0; column < kColumns; ++column) {
        const glm::dvec3 p((column - (kColumns - 1) / 2.0) * kSpacing, kRadius + layer * kSpacing,
                           -(kRows - 1 - row) * kSpacing);
        const int material = (row + 3 * layer) % kColourCount * kFinishes + column * kFinishes / kColumns;
        place(scene, fmt::format("sphere {}-{}-{}", layer + 1, row + 1, column + 1), sphere, material, standing_at(p));
      }
}

Light spot(glm::dvec3 from, glm::dvec3 at, glm::dvec3 colour, double inner_deg, double outer_deg) {
  Light light;
  light.kind = LightKind::spot;
  light.position = from;
  light.direction = glm::normalize(at - from);
  light.colour = colour;
  light.range = 22;
  light.inner_cos = std::cos(glm::radians(inner_deg));
  light.outer_cos = std::cos(glm::radians(outer_deg));
  return light;
}

void add_lights(Scene& scene) {
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = glm::normalize(glm::dvec3(0.4, -0.8, -0.45));
  sun.colour = {0.34, 0.36, 0.42};
  scene.lights.push_back(sun);
  const auto add_point = [&scene](glm::dvec3 p, double range, glm::dvec3 colour) {
    Light light;
    light.position = p, light.range = range, light.colour = colour;
    scene.lights.push_back(light);
  };
  add_point({-5.25, 2.4, -1.5}, 6, {2.4, 1.5, 0.8});
  add_point({4.9, 2.6, -2.2}, 6, {0.9, 1.5, 2.6});
  add_point({-2.2, 5.6, -9.5}, 7, {1.1, 2.2, 1.3});
  add_point({5.6, 5.2, -10.5}, 7, {2.3, 0.9, 1.7});
  scene.lights.push_back(spot({0, 9, 3}, {0, 1, -4}, {3.2, 3.0, 2.5}, 10, 17));
  scene.lights.push_back(spot({-10, 10, -6}, {-3, 2, -8}, {1.4, 2.2, 3.2}, 9, 16));
}

}  // namespace

Scene build_spheres() {
  Scene scene;
  scene.name = "spheres";
  add_materials(scene);
  add_spheres(scene);
  const int floor =
      add(scene, make_plaster(256, 2), {.name = "floor", .base_colour = {0.3f, 0.31f, 0.34f, 1}, .roughness = 0.75f});
  place(scene, "floor", make_sheet({-80, 0, 14}, {160, 0, 0}, {0, 0, -120}, 0.25, {20, 20}), floor);
  add_lights(scene);
  scene.bounds = bounds_of(scene);
  scene.light_box = LightBox{{-8, 0.5, -14.5}, {8, 5.5, 1}};
  scene.camera = camera_at({6.8, 8.2, 8.2}, 28, -31, 45, 0.1, 300);
  return scene;
}

}  // namespace gbl
