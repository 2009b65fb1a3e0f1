// The sweep that shows most at once: every way to draw a light's volume, in three families of random configurations of
// one light. Seeded: a configuration is the same on every machine.
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "renderer/base/random.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/study/stability/stability_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

enum class Family { in_ball, at_surface, at_far_plane };
constexpr double kFar = 100;

std::vector<double> configurations() { return family_values(48); }

// Ground with pillars: edges, and walls to all sides.
std::shared_ptr<Scene> pillars() {
  auto scene = std::make_shared<Scene>();
  Mesh ground = make_box({-150, -1, -150}, {150, 0, 60}, 1);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 7; ++j)
      append(ground, make_box({25 * i - 64, 0, -20 * j - 2}, {25 * i - 61, 9, -20 * j + 1}, 1), glm::dmat4(1));
  scene->meshes = {ground};
  scene->materials = {{.name = "white"}};
  scene->instances = {{"ground", 0, 0, glm::dmat4(1)}};
  scene->bounds = bounds_of(*scene);
  return scene;
}

Camera camera() {
  Camera c;
  c.position = {0, 6, 20};
  c.orientation = orientation_from_yaw_pitch(0, -10);
  c.near = 0.5, c.far = kFar;
  return c;
}

glm::dvec3 direction(Pcg32& random) {
  const double z = random.in(-1, 1), turn = random.in(0, 2 * glm::pi<double>()), flat = std::sqrt(1 - z * z);
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

Light any_light(Family family, const Camera& c, Pcg32& random) {
  const double range = family == Family::in_ball ? 20 : random.in(8, 30);
  switch (family) {
    case Family::in_ball: {
      const double distance = 2 * range * std::cbrt(random.unit());  // uniform in the ball
      return lamp(c.position + distance * direction(random), range);
    }
    case Family::at_surface: {
      const double gap = random.in(-1, 1);
      return lamp(c.position + (range + gap) * direction(random), range);
    }
    case Family::at_far_plane: {
      const double along = kFar + range * random.in(-1, 0.5), sideways = random.in(-40, 40);
      return lamp(c.position + along * c.forward() + sideways * c.right() + random.in(-5, 15) * c.up(), range);
    }
  }
  return {};
}

// Does it light the ground where the picture shows it? Else the configuration says nothing.
bool seen(const Light& light, const Camera& c) {
  if (light.position.y < 1) return false;
  const ViewRays rays = view_rays(c, 16.0 / 9);
  int lit = 0;
  for (double y = -0.95; y < 1; y += 0.1)
    for (double x = -0.95; x < 1; x += 0.1) {
      const glm::dvec3 ray = rays.forward + x * rays.right + y * rays.up;
      if (ray.y >= 0) continue;
      const double range = -c.position.y / ray.y;
      lit += range < c.far && glm::distance(c.position + range * ray, light.position) < 0.9 * light.range;
    }
  return lit >= 3;
}

Light seen_light(Family family, int number, const Camera& c) {
  Pcg32 random(static_cast<uint64_t>(number), static_cast<uint64_t>(family) + 1);
  Light light = any_light(family, c, random);
  while (!seen(light, c)) light = any_light(family, c, random);
  return light;
}

SweepSetup configuration(double value) {
  const int family = static_cast<int>(value) / kFamilySpan, number = static_cast<int>(value) % kFamilySpan;
  static const std::shared_ptr<const Scene> kPillars = pillars();
  auto scene = std::make_shared<Scene>(*kPillars);
  scene->name = fmt::format("sweep:cull-families/{}", value);
  const Camera c = camera();
  scene->lights = {seen_light(static_cast<Family>(family), number, c)};
  SweepSetup setup{exact_settings(scene->name, {96, 54}), scene};
  setup.settings.camera = c;
  setup.settings.lights.method = LightMethod::volumes;
  return setup;
}

// ---- the variants ---------------------------------------------------------------------------------------------------

// Shares of the configurations of family A, B and C that have a wrong pixel.
std::vector<Expected> shares(double a, double b, double c) {
  std::vector<Expected> out;
  for (const double share : {a, b, c}) {
    const double from = static_cast<double>(out.size()) * kFamilySpan;
    out.push_back(FailsOften{.from = from, .to = from + kFamilySpan - 1, .bound = 0, .share = share});
  }
  return out;
}

using Volume = Settings::Lights::Volume;

Curve variant(std::string id, LightCull cull, Volume volume, std::vector<Expected> expected) {
  return {std::move(id), [=](Settings& s) { s.lights.cull = cull, s.lights.volume = volume; }, std::move(expected)};
}

Curve by_method(LightMethod method, std::vector<Expected> expected) {
  return {row(method).id, [=](Settings& s) { s.lights.method = method; }, std::move(expected)};
}

std::vector<Curve> variants(const DeviceRounding&) {
  using C = LightCull;
  using L = VolumeLevel;
  const auto in = VolumeFit::inscribed, out = VolumeFit::circumscribed;
  const auto planes = VolumeClip::planes, clamp = VolumeClip::none;
  const auto untested = VolumeDepth::none, behind = VolumeDepth::greater_equal;
  // Shares of 400 configurations of each family; the sound four were right in all 1200.
  return {
      variant("back", C::back, {L::l2, out, planes, untested}, shares(0.36, 0.86, 0)),
      variant("back unclipped", C::back, {L::l2, out, clamp, untested}, shares(0.34, 0.57, 0)),
      variant("none", C::none, {L::l2, out, planes, untested}, shares(0.66, 0.31, 0.7)),
      variant("flip inscribed l2", C::flip, {L::l2, in, planes, untested}, shares(0.17, 0.16, 0.003)),
      variant("flip l1", C::flip, {L::l1, out, planes, untested}, shares(0.05, 0.46, 0)),
      variant("flip l3", C::flip, {L::l3, out, planes, untested}, shares(0.025, 0.3, 0)),
      variant("front", C::front, {L::l2, out, planes, untested}, shares(0, 0, 0.988)),
      by_method(LightMethod::disc, shares(0.44, 0.49, 0.135)),
      variant("flip-safe", C::flip_safe, {L::l2, out, planes, untested}, shares(0, 0, 0)),
      variant("front unclipped", C::front, {L::l2, out, clamp, untested}, shares(0, 0, 0)),
      variant("front unclipped ge", C::front, {L::l2, out, clamp, behind}, shares(0, 0, 0)),
      by_method(LightMethod::volumes_stencil, shares(0, 0, 0)),
  };
}

}  // namespace

std::vector<double> family_values(int configurations_of_each) {
  std::vector<double> out;
  for (int family = 0; family < kFamilies; ++family)
    for (int k = 0; k < configurations_of_each; ++k) out.push_back(family * kFamilySpan + k);
  return out;
}

Sweep cull_families_sweep() {
  return {.id = "cull-families",
          .label = "Twelve ways to draw a light's volume",
          .parameter = "configuration",
          .unit = "",
          .log_axis = false,
          .metric = "over_1_255_linear",
          .help =
              "random configurations of one light that lights the ground in view. A: within twice its range of the "
              "camera. B: camera within a unit of the volume's surface. C: at the far plane",
          .values = configurations,
          .curves = variants,
          .at = configuration};
}

}  // namespace gbl
