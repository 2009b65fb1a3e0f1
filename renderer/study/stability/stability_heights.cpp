// Sweeps of parallax: how far from the exact height field a line of sight ends.
#include <cmath>
#include <fmt/format.h>

#include "renderer/scenes/scene_parts.h"
#include "renderer/study/stability/stability_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

constexpr double kHalf = 2;  // of the wall, in units and in tiles of the bricks

// A brick wall that is seen at this angle to its plane, in degrees, so that its middle is four units away. The truth depends on
// the angle alone.
SweepSetup bricks_seen_at(double degrees) {
  SweepSetup out = wall_setup(fmt::format("sweep:bricks/{:g}", degrees), {160, 90}, wall_at({0, 0, 0}, kHalf),
                              {lamp({0, 1, 3}, 20)});
  auto scene = std::make_shared<Scene>(*out.scene);
  scene->materials.clear();
  add_relief(*scene, make_bricks(256, 1), {.name = "bricks"}, 1, 3);
  for (Vertex& v : scene->meshes[0].vertices) v.uv *= static_cast<float>(2 * kHalf);
  const double angle = glm::radians(degrees);
  Settings& s = out.settings;
  s.camera.position = 4.0 * glm::dvec3(std::cos(angle), 0, std::sin(angle));
  s.camera.orientation = orientation_from_yaw_pitch(90 - degrees, 0);
  s.camera.near = 0.1, s.camera.far = 50;
  s.normal_map = NormalMap::on;
  s.height_map = HeightMap::on;
  out.scene = std::move(scene);
  return out;
}

constexpr double kGrazing = 20;  // degrees

SweepSetup seen_in_steps(double steps) {
  static const SweepSetup wall = bricks_seen_at(kGrazing);
  SweepSetup out = wall;
  out.settings.parallax.steps = static_cast<int>(steps);
  return out;
}

Curve curve_of(ParallaxMethod m, std::vector<Expected> expected) {
  return {fmt::format("parallax.method={}", row(m).id), [m](Settings& s) { s.parallax.method = m; },
          std::move(expected)};
}
Curve curve_of(ParallaxMethod m, int steps, std::vector<Expected> expected) {
  return {fmt::format("parallax.method={} steps={}", row(m).id, steps),
          [m, steps](Settings& s) { s.parallax.method = m, s.parallax.steps = steps; }, std::move(expected)};
}

std::vector<double> step_counts() { return {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256}; }

// A step too far is on average half of the depth over the number of steps, along a line of sight that comes in at 20 degrees.
std::vector<Curve> step_curves(const DeviceRounding&) {
  return {
      curve_of(ParallaxMethod::offset, {Flat{0.012}}),
      curve_of(ParallaxMethod::steep,
               {Grows{.slope = -1, .tolerance = 0.1, .from = 2, .at = 32, .low = 0.001, .high = 0.0015}}),
      curve_of(ParallaxMethod::occlusion,
               {Grows{.slope = -1.3, .tolerance = 0.2, .at = 32, .low = 5e-5, .high = 2e-4, .spread = 3}}),
      curve_of(ParallaxMethod::relief, {FailsIn{.from = 1, .to = 4, .beyond = 48, .holds = 2e-4, .fails = 7e-4}}),
  };
}

std::vector<double> angles() { return {3, 4, 5, 6, 8, 10, 14, 20, 28, 40, 60, 90}; }

std::vector<Curve> angle_curves(const DeviceRounding&) {
  const auto fails_up_to = [](double to, double beyond) {
    return FailsIn{.from = 3, .to = to, .beyond = beyond, .holds = 2.5e-4, .fails = 8e-4};
  };
  return {
      curve_of(ParallaxMethod::none,
               {Grows{.slope = -0.8, .tolerance = 0.15, .to = 28, .at = 10, .low = 0.025, .high = 0.04}}),
      curve_of(ParallaxMethod::offset, {Grows{.slope = -1.1, .tolerance = 0.2, .at = 20, .low = 0.008, .high = 0.014}}),
      curve_of(ParallaxMethod::steep, 32,
               {Grows{.slope = -0.9, .tolerance = 0.15, .at = 20, .low = 0.001, .high = 0.0016}}),
      curve_of(ParallaxMethod::occlusion, 8, {fails_up_to(14, 40)}),
      curve_of(ParallaxMethod::occlusion, 32, {fails_up_to(5, 14)}),
      curve_of(ParallaxMethod::relief, 32, {fails_up_to(4, 10)}),
  };
}

}  // namespace

Sweep parallax_steps_sweep() {
  return {.id = "parallax-steps",
          .label = "How many steps a height map needs",
          .parameter = "steps down a height map",
          .unit = "",
          .log_axis = true,
          .metric = "position_mean",
          .help =
              "a brick wall seen at 20 degrees to its plane: stairs of a step's height, and what is left when the last "
              "step "
              "is interpolated or halved",
          .values = step_counts,
          .curves = step_curves,
          .at = seen_in_steps,
          .keeps = {"height-map", "parallax.steps"}};
}

Sweep parallax_angle_sweep() {
  return {.id = "parallax-angle",
          .label = "How flat a height map can be looked at",
          .parameter = "angle to the wall's plane",
          .unit = "degrees",
          .log_axis = true,
          .metric = "position_mean",
          .help = "a brick wall seen from along it to head on: what each method makes of the same height map",
          .values = angles,
          .curves = angle_curves,
          .at = bricks_seen_at};
}

}  // namespace gbl
