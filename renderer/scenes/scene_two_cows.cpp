// Source 0's figures of light volumes (nclgl tutorial 15, "Light Volumes"): two cows of the same size on the screen,
// one inside the light, one far behind it; and two more lights, A around nothing and B around part of a tree.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/procedural_texture.h"
#include "renderer/scenes/scene_parts.h"
#include "renderer/scenes/scene_plants.h"
#include "renderer/scenes/scene_props.h"
#include "renderer/scenes/texture_painting.h"

namespace gbl {
namespace {

constexpr glm::dvec3 kEye(0, 1.6, 0);
constexpr Bounds kNearCow{{-1.55, 0, -8.2}, {-0.45, 0.8, -7.8}};
constexpr double kTimesAsFar = 3;
constexpr double kDrop = 3.2;  // of the ground between the cows: what was at 0 is at -3.2 three times as far
constexpr glm::dvec3 kTree(2.2, 0, -9);

// The upper ground ends in a bank. Where the far cow is seen it ends early, or its edge would hide the hooves; the
// near cow and the tree stand on spurs to both sides of that gap. Directions are x per metre ahead.
double ground_height(double x, double z, const TileNoise& noise) {
  const double ahead = std::max(-z, 0.5), direction = x / ahead + 0.01 * noise.at(x / 16, z / 16, 16);
  const double left_spur = 1 - smoothstep(-0.03, 0.05, direction), right_spur = smoothstep(0.205, 0.23, direction);
  const double edge = 5.4 + 4 * std::max(left_spur, right_spur);
  const double waves = 0.25 * noise.at(x / 64, z / 64, 16);
  const double below = smoothstep(edge, edge + 2.2, waves - z);
  const double far = smoothstep(32, 102, ahead) + smoothstep(26, 66, std::abs(x));
  const double hills = (4.5 + 7 * noise.fractal(x / 256, z / 256, 8, 3)) * far;
  return -kDrop * below + std::max(hills, 0.0) * below;
}

// Lines run closer together where the cows are.
double place_x(double s) { return 75 * (0.1 * s + 0.9 * s * s * s); }  // s: -1..1
double place_z(double s) { return -9 - (s > 0 ? 110 * (0.08 * s + 0.92 * s * s * s) : 13 * s); }

Mesh make_bank() {
  constexpr int kSide = 144;
  const TileNoise noise(30);
  std::vector<double> x, z;
  for (int i = 0; i <= kSide; ++i) {
    const double s = 2.0 * i / kSide - 1;
    x.push_back(place_x(s));
    z.push_back(place_z(-s));
  }
  return make_ground(
      x, z, [&noise](double px, double pz) { return ground_height(px, pz, noise); }, 0.4);
}

glm::dmat4 fitted(const Mesh& mesh, const Bounds& box) {
  const Bounds own = bounds_of(mesh);
  return glm::translate(glm::scale(glm::translate(glm::dmat4(1), box.min), box.extent() / own.extent()), -own.min);
}

// Seen from the eye, a thing and its image under this are mirror images of each other.
glm::dmat4 far_image() {
  const glm::dmat4 about_eye = glm::translate(glm::dmat4(1), kEye);
  return glm::translate(glm::scale(about_eye, {-kTimesAsFar, kTimesAsFar, kTimesAsFar}), -kEye);
}

void add_lights(Scene& scene) {
  const auto add_light = [&scene](glm::dvec3 position, double range, glm::dvec3 colour) {
    Light light;
    light.position = position, light.range = range, light.colour = colour;
    scene.lights.push_back(light);
  };
  add_light({0, 0.9, -8}, 2.4, {2.6, 2.1, 1.4});    // around the near cow
  add_light({-3, 3.2, -9}, 1.2, {0.9, 1.4, 2.0});   // A, around nothing
  add_light({2.2, 1.8, -9}, 1.5, {1.4, 2.4, 1.5});  // B, around part of the tree
}

}  // namespace

Scene build_two_cows() {
  Scene scene;
  scene.name = "two-cows";
  const int grass = add(scene, make_grass(256, 5), {.name = "grass", .normal_scale = 0.7f});
  const int bark = add(scene, make_bark(256, 6), {.name = "bark"});
  const int leaves = add(scene, make_foliage(256, 7), {.name = "leaves"});
  const int paint = add(scene, Material{.name = "paint", .roughness = 0.55f});
  scene.materials[paint].base_colour_texture = {add(scene, make_paint(256, 4))};

  place(scene, "ground", make_bank(), grass);
  const int cow = add(scene, make_cow(), "cow");
  const glm::dmat4 near = fitted(scene.meshes[cow], kNearCow);
  place(scene, "near cow", cow, paint, near);
  place(scene, "far cow", cow, paint, far_image() * near);
  Tree tree = make_tree({.height = 4.3, .trunk = 2.2, .radius = 0.12, .crown = 1, .rounds = 11, .seed = 12});
  // Away from the eye: light B is at its axis, and what it lights must be seen.
  const glm::dmat4 leaning = glm::rotate(standing_at(kTree), glm::radians(-11.0), {1, 0, 0});
  place(scene, "tree trunk", add(scene, std::move(tree.wood), "trunk"), bark, leaning);
  place(scene, "tree crown", add(scene, std::move(tree.foliage), "crown"), leaves, leaning);

  add_lights(scene);
  scene.bounds = bounds_of(scene);
  scene.light_box = LightBox{{-6, -3, -26}, {6, 3, -6}};
  scene.camera = camera_at(kEye, 0, 0, 45, 0.1, 400);
  return scene;
}

}  // namespace gbl
