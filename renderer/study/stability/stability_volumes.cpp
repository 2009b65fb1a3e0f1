// Sweeps of light volumes: the camera through one, the far plane through one, meshes from coarse to fine.
#include <fmt/format.h>

#include "renderer/light/light_volume.h"
#include "renderer/study/stability/stability_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kSize{96, 54};

void draw_volumes(Settings& s) {
  s.lights.method = LightMethod::volumes;
  s.lights.volume = {VolumeLevel::l2, VolumeFit::circumscribed, VolumeClip::planes, VolumeDepth::none};
}

// ---- light-distance -------------------------------------------------------------------------------------------------

constexpr double kRange = 2, kNear = 0.5;

std::vector<double> light_distances() {
  return {-0.4, 0,    0.4,  0.8, 1.2,  1.6,  1.8,  1.9, 1.95, 1.98, 2, 2.02, 2.05, 2.1, 2.2, 2.3,
          2.4,  2.45, 2.48, 2.5, 2.52, 2.54, 2.56, 2.6, 2.7,  2.8,  3, 3.5,  4,    5,   6};
}

SweepSetup light_at_distance(double distance) {
  SweepSetup setup = wall_setup(fmt::format("sweep:light-distance/{}", distance), kSize, wall_at({0, 0, -1}, 20),
                                {lamp({0, 0, 0}, kRange)});
  setup.settings.camera.position = {0, 0, distance};
  setup.settings.camera.near = kNear, setup.settings.camera.far = 100;
  draw_volumes(setup.settings);
  return setup;
}

Curve cull_curve(LightCull cull, VolumeFit fit, Expected expected) {
  return {fmt::format("cull={} fit={}", row(cull).id, row(fit).id),
          [=](Settings& s) { s.lights.cull = cull, s.lights.volume.fit = fit; },
          {expected}};
}

// Along this axis the inscribed mesh ends at 1.99, the circumscribed one at 2.03. The near plane is half a unit further,
// and its corners leave the volume a little before its middle.
std::vector<Curve> light_distance_curves(const DeviceRounding&) {
  using C = LightCull;
  const auto out = VolumeFit::circumscribed, in = VolumeFit::inscribed;
  const auto from = [](double before, double first) {
    return FailsIn{.before = before, .from = first, .to = kNoEnd, .holds = 0, .fails = 0.99};
  };
  const auto until = [](double before, double first, double last, double beyond) {
    return FailsIn{.before = before, .from = first, .to = last, .beyond = beyond, .holds = 0, .fails = 0.99};
  };
  return {
      cull_curve(C::back, out, until(-kNoEnd, -0.4, 2.45, 2.56)),
      cull_curve(C::flip, out, until(1.98, 2, 2.45, 2.56)),
      cull_curve(C::none, out, from(2.45, 2.56)),
      cull_curve(C::front, out, Flat{0}),
      cull_curve(C::flip_safe, out, Flat{0}),
      cull_curve(C::back, in, until(-kNoEnd, -0.4, 2.4, 2.52)),
      cull_curve(C::flip, in, until(1.98, 2, 2.4, 2.52)),
      cull_curve(C::none, in, from(2.4, 2.52)),
      cull_curve(C::front, in, Flat{0.01}),
      cull_curve(C::flip_safe, in, Flat{0.01}),
  };
}

// ---- near-corner ----------------------------------------------------------------------------------------------------

std::vector<double> corner_distances() {
  return {1.9, 1.98, 2.02, 2.1, 2.3, 2.5, 2.6, 2.64, 2.66, 2.7, 2.75, 2.8, 2.9, 3, 3.1, 3.15, 3.2, 3.3, 3.5, 4};
}

// Turns `from` to `to`, both of length 1 and not opposite.
glm::dquat turning(const glm::dvec3& from, const glm::dvec3& to) {
  return glm::normalize(glm::dquat(1 + glm::dot(from, to), glm::cross(from, to)));
}

// The camera leaves a bare icosahedron over one of its corners, and looks so that the light lies in the picture's own
// corner: what is nearest to the mesh's farthest point is the near plane's farthest one.
SweepSetup corner_at_distance(double distance) {
  const glm::dvec3 outwards = glm::normalize(glm::dvec3(icosphere(0).vertices.front()));
  glm::dmat4 world_from_wall(glm::dmat4(glm::mat3_cast(turning({0, 0, 1}, outwards))) * glm::dmat4(glm::dmat3(20)));
  world_from_wall[3] = glm::dvec4(-outwards, 1);
  SweepSetup setup =
      wall_setup(fmt::format("sweep:near-corner/{}", distance), kSize, world_from_wall, {lamp({0, 0, 0}, kRange)});
  Settings& s = setup.settings;
  s.camera.position = distance * outwards;
  s.camera.near = kNear, s.camera.far = 100;
  const double height = s.camera.half_height(double(kSize.x) / kSize.y), width = height * kSize.x / kSize.y;
  s.camera.orientation = turning(glm::normalize(glm::dvec3(width, height, -1)), -outwards);
  draw_volumes(s);
  s.lights.volume.level = VolumeLevel::l0;
  return setup;
}

Curve corner_curve(LightMethod method, LightCull cull, Expected expected) {
  return {fmt::format("{} cull={}", row(method).id, row(cull).id),
          [=](Settings& s) { s.lights.method = method, s.lights.cull = cull; },
          {expected}};
}

// The mesh's corner is 2.52 away from the centre, and the near plane's 0.65 from the camera.
std::vector<Curve> near_corner_curves(const DeviceRounding&) {
  std::vector<Curve> out;
  for (const LightMethod m : {LightMethod::volumes, LightMethod::volumes_instanced}) {
    out.push_back(
        corner_curve(m, LightCull::flip,
                     FailsIn{.before = 1.98, .from = 2.02, .to = 2.5, .beyond = 3.2, .holds = 0, .fails = 0.99}));
    out.push_back(corner_curve(m, LightCull::flip_safe, Flat{0}));
    out.push_back(corner_curve(m, LightCull::front, Flat{0}));
  }
  return out;
}

// ---- far-plane ------------------------------------------------------------------------------------------------------

std::vector<double> far_planes() {
  return {106, 108, 110, 112, 115, 120, 125, 130, 135, 138, 140, 141, 142, 143, 145, 150, 170, 200};
}

// The light's centre is 100 units away, its range 40, the wall 5 units behind it: surfaces are always in front of the
// far plane, the volume's back faces not.
SweepSetup far_plane_at(double far) {
  SweepSetup setup =
      wall_setup(fmt::format("sweep:far-plane/{}", far), kSize, wall_at({0, 0, -105}, 150), {lamp({0, 0, -100}, 40)});
  setup.settings.camera.near = 1, setup.settings.camera.far = far;
  draw_volumes(setup.settings);
  return setup;
}

Curve clip_curve(VolumeClip clip, LightCull cull, Expected expected) {
  return {fmt::format("clip={} cull={}", row(clip).id, row(cull).id),
          [=](Settings& s) { s.lights.volume.clip = clip, s.lights.cull = cull; },
          {expected}};
}

std::vector<Curve> far_plane_curves(const DeviceRounding&) {
  using C = LightCull;
  return {
      clip_curve(VolumeClip::planes, C::front,
                 FailsIn{.from = 106, .to = 112, .beyond = 143, .holds = 0, .fails = 0.8}),
      clip_curve(VolumeClip::planes, C::back, Flat{0}),
      clip_curve(VolumeClip::planes, C::flip_safe, Flat{0}),
      clip_curve(VolumeClip::none, C::front, Flat{0}),
      clip_curve(VolumeClip::none, C::back, Flat{0}),
  };
}

// ---- volume-level ---------------------------------------------------------------------------------------------------

std::vector<double> levels() { return {0, 1, 2, 3, 4}; }

// Seen without perspective, so that the mesh's outline and the lit disc are nearly the same circle; two units off the
// wall, where the rim still faces the light enough to be seen.
SweepSetup volume_level_at(double level) {
  SweepSetup setup = wall_setup("sweep:volume-level", {160, 90}, wall_at({0, 0, -2}, 100), {lamp({0, 0, 0}, 20)});
  setup.settings.camera.position = {0, 0, 60};
  setup.settings.camera.orthographic_height = 42;
  setup.settings.camera.far = 200;
  draw_volumes(setup.settings);
  setup.settings.lights.cull = LightCull::front;
  setup.settings.lights.volume.clip = VolumeClip::none;
  setup.settings.lights.volume.level = static_cast<VolumeLevel>(static_cast<int>(level));
  return setup;
}

Curve fit_curve(VolumeFit fit, Attenuation attenuation, std::vector<Expected> expected) {
  return {fmt::format("fit={} attenuation={}", row(fit).id, row(attenuation).id),
          [=](Settings& s) { s.lights.volume.fit = fit, s.attenuation = attenuation; }, std::move(expected)};
}

// The linear falloff is faint at the rim: there the finer meshes' notches cannot be seen.
std::vector<Curve> volume_level_curves(const DeviceRounding&) {
  const auto out = VolumeFit::circumscribed, in = VolumeFit::inscribed;
  const FailsIn coarsest{.from = 0, .to = 0, .beyond = 2, .holds = 0.02, .fails = 0.15};
  const auto coarse = [](double lost) {
    return FailsIn{.from = 0, .to = 1, .beyond = 3, .holds = 0.002, .fails = lost};
  };
  return {
      fit_curve(in, Attenuation::none, {coarsest, coarse(0.04)}),
      fit_curve(in, Attenuation::linear, {coarsest, coarse(0.005)}),
      fit_curve(out, Attenuation::none, {Flat{0}}),
      fit_curve(out, Attenuation::linear, {Flat{0}}),
  };
}

}  // namespace

Sweep light_distance_sweep() {
  return {.id = "light-distance",
          .label = "The camera leaves a light's volume",
          .parameter = "distance of the camera from the light's centre",
          .unit = "units",
          .log_axis = false,
          .metric = "wrong_light_share",
          .help =
              "a light of range 2 before a wall, near plane 0.5, volumes clipped by the planes: each culling rule "
              "loses or doubles the whole light in its own band",
          .values = light_distances,
          .curves = light_distance_curves,
          .at = light_at_distance};
}

Sweep near_corner_sweep() {
  return {.id = "near-corner",
          .label = "The near plane's corner leaves a light's mesh",
          .parameter = "distance of the camera from the light's centre",
          .unit = "units",
          .log_axis = false,
          .metric = "wrong_light_share",
          .help =
              "a light of range 2 in an icosahedron, seen in the corner of the picture: a rule without the mesh's own "
              "size, "
              "or without the near plane's corner, loses it",
          .values = corner_distances,
          .curves = near_corner_curves,
          .at = corner_at_distance};
}

Sweep far_plane_sweep() {
  return {.id = "far-plane",
          .label = "The far plane through a light's volume",
          .parameter = "far plane",
          .unit = "units",
          .log_axis = false,
          .metric = "lost_share",
          .help = "a light of range 40, 100 units away, a wall 5 units behind it: back faces end at 140 to 143",
          .values = far_planes,
          .curves = far_plane_curves,
          .at = far_plane_at};
}

Sweep volume_level_sweep() {
  return {.id = "volume-level",
          .label = "Light volumes from coarse to fine",
          .parameter = "level of the icosphere",
          .unit = "",
          .log_axis = false,
          .metric = "lost_share",
          .help = "a light of range 20, 2 units off a wall: a mesh inside the sphere cuts notches into the rim",
          .values = levels,
          .curves = volume_level_curves,
          .at = volume_level_at,
          .keeps = {"lights.volume.level"}};
}

}  // namespace gbl
