// Sweeps of normal encodings: over the sphere from the pole -Z, and under highlights from matte to smooth.
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "renderer/scenes/mesh_builder.h"
#include "renderer/study/stability/stability_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

constexpr int kStrips = 48;

// ---- normal-angle ---------------------------------------------------------------------------------------------------

std::vector<double> angles_deg() {
  return {1e-4, 3e-4, 0.001, 0.003, 0.006, 0.01, 0.012, 0.013, 0.0135, 0.015, 0.016, 0.02, 0.025, 0.03,  0.05,
          0.1,  0.2,  0.5,   1,     2,     5,    10,    20,    30,     45,    60,    75,   85,    89,    89.5,
          90,   90.5, 91,    95,    105,   120,  135,   150,   165,    175,   178,   179,  179.5, 179.9, 180};
}

// A wall that faces the camera, in upright strips whose shading normals all stand at this angle to -Z, a strip for each
// of kStrips directions about it: no code is judged by one lucky direction.
Mesh strips(double angle_deg) {
  Mesh m;
  const double polar = glm::radians(angle_deg);
  for (int i = 0; i < kStrips; ++i) {
    const double turn = 2 * glm::pi<double>() * (i + 0.37) / kStrips;
    const glm::vec3 normal(
        glm::dvec3(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), -std::cos(polar)));
    const auto first = static_cast<uint32_t>(m.vertices.size());
    for (const glm::vec2 corner : {glm::vec2(0, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(0, 1)})
      m.vertices.push_back({.position = {2 * (i + corner.x) / kStrips - 1, corner.y, 0}, .normal = normal});
    m.indices.insert(m.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }
  set_tangents(m);
  return m;
}

SweepSetup normals_at(double angle_deg) {
  auto scene = std::make_shared<Scene>();
  scene->name = fmt::format("sweep:normal-angle/{}", angle_deg);
  scene->meshes = {strips(angle_deg)};
  scene->materials = {{.name = "white"}};
  scene->instances = {{"strips", 0, 0, wall_at({0, 0, -1.5}, 1.2)}};
  scene->lights = {lamp({0, 0, 0}, 10)};
  scene->bounds = bounds_of(*scene);
  SweepSetup setup{exact_settings(scene->name, {2 * kStrips, 54}), scene};
  setup.settings.camera.near = 0.1, setup.settings.camera.far = 10;
  return setup;
}

// The table's bound, and a hundredth more for the frame's float arithmetic.
double bound_deg(NormalEncoding e, const DeviceRounding& rounding) {
  const EncodingRow& r = row_of(e);
  const bool truncates = r.toward_zero && rounding.half_store == StoreRounding::toward_zero;
  return 1.01 * (truncates ? r.toward_zero->max : r.error.max) + 2e-5;
}

Expected expected_of(NormalEncoding e, const DeviceRounding& rounding) {
  const double bound = bound_deg(e, rounding);
  switch (e) {
    // Within 0.0140 degrees of -Z, acos(1 - 2^-25), 1 + z is 0 in float: no code, no direction. Up to 0.03 a device that
    // is a step of float off when it normalises still rounds z to -1.
    case NormalEncoding::stereo16f:
      return FailsIn{.from = 1e-4, .to = 0.0135, .beyond = 0.05, .holds = bound, .fails = 179};
    // What faces -Z is mirrored: off by 180 degrees less twice the angle.
    case NormalEncoding::xy_sqrt: return FailsIn{.from = 1e-4, .to = 89, .beyond = 90, .holds = 1.6, .fails = 1.9};
    // Negative components become 0; of normals about +Z what is lost is small.
    case NormalEncoding::xyz8_raw: return FailsIn{.from = 1e-4, .to = 179, .beyond = 180, .holds = 0.01, .fails = 0.9};
    default: return Flat{bound};
  }
}

std::vector<Curve> encoding_curves(const DeviceRounding& rounding) {
  std::vector<Curve> out;
  for (const ValueRow& r : rows<NormalEncoding>()) {
    const auto e = static_cast<NormalEncoding>(r.value);
    out.push_back({r.id, [e](Settings& s) { s.normal.encoding = e; }, {expected_of(e, rounding)}});
  }
  return out;
}

// ---- roughness ------------------------------------------------------------------------------------------------------

std::vector<double> roughnesses() {
  return {0.02, 0.05, 0.08, 0.12, 0.16, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1};
}

// A black, glossy dome that fills the picture: highlights and nothing else.
SweepSetup dome_of(double roughness) {
  auto scene = std::make_shared<Scene>();
  scene->name = fmt::format("sweep:roughness/{}", roughness);
  scene->meshes = {make_ellipsoid({10, 10, 10}, 256, 128)};
  scene->materials = {{.name = "gloss", .base_colour = {0, 0, 0, 1}, .roughness = static_cast<float>(roughness)}};
  scene->instances = {{"dome", 0, 0, glm::dmat4(1)}};
  scene->lights = {lamp({2, 3, 16}, 100)};
  scene->bounds = bounds_of(*scene);
  SweepSetup setup{exact_settings(scene->name, {160, 90}), scene};
  setup.settings.camera.position = {0, 0, 14};
  setup.settings.camera.far = 100;
  setup.settings.shading.model = ShadingModel::blinn_phong;
  return setup;
}

// Half a step of an angle changes a lobe of exponent e = 2 / roughness^4 - 2, scaled by e, by about e sqrt(e) of it:
// the power -6 of roughness, a little less where e is small. `at_03`: the error at roughness 0.3.
Curve gloss_curve(NormalEncoding e, double at_03, double seen_to, double unseen_from) {
  return {
      row(e).id,
      [e](Settings& s) { s.normal.encoding = e; },
      {FailsIn{.from = 0.02, .to = seen_to, .beyond = unseen_from, .holds = 1.0 / 255, .fails = 1.0 / 255},
       Grows{.slope = -5.7, .tolerance = 0.5, .from = 0.2, .to = 0.6, .at = 0.3, .low = at_03 / 2, .high = 2 * at_03}}};
}

std::vector<Curve> roughness_curves(const DeviceRounding&) {
  using E = NormalEncoding;
  const auto keep_all = [](Settings& s) { s.normal.encoding = E::xyz32f; };
  return {
      gloss_curve(E::oct8, 0.07, 0.3, 0.6),
      gloss_curve(E::xyz8, 0.052, 0.3, 0.6),
      gloss_curve(E::bestfit8, 0.03, 0.3, 0.5),
      gloss_curve(E::xyz10, 0.012, 0.25, 0.5),
      gloss_curve(E::oct12, 0.0037, 0.25, 0.4),
      gloss_curve(E::oct14, 0.001, 0.16, 0.3),
      gloss_curve(E::oct16, 0.00024, 0.16, 0.25),
      {row(E::xyz32f).id,
       keep_all,
       {Flat{0.05}, FailsIn{.from = 0.02, .to = 0.12, .beyond = 0.2, .holds = 0.002, .fails = 0.002}}},
  };
}

// ---- sub-pixel-pan --------------------------------------------------------------------------------------------------

std::vector<double> pans_px() {
  std::vector<double> out;
  for (int eighths = 0; eighths <= 32; ++eighths) out.push_back(eighths / 8.0);
  return out;
}

// The dome, and a camera that goes to the right beside it: what moves between two frames is less than a pixel.
SweepSetup dome_seen_from(double pan_px) {
  SweepSetup setup = dome_of(0.15);
  auto scene = std::make_shared<Scene>(*setup.scene);
  scene->name = fmt::format("sweep:sub-pixel-pan/{}", pan_px);
  setup.scene = scene;
  Settings& s = setup.settings;
  s.scene = scene->name;
  s.exposure = 0.005;  // the brightest point is to be seen, not clipped
  const double to_the_dome = s.camera.position.z - 10;
  const double pixel = 2 * to_the_dome * s.camera.half_height(double(s.size.x) / s.size.y) / s.size.y;  // world units
  s.camera.position.x = pan_px * pixel;
  return setup;
}

// Half and twice what is expected of each; the last two are the frame's own float arithmetic.
std::vector<Curve> pan_curves(const DeviceRounding&) {
  using E = NormalEncoding;
  const auto curve = [](E e, double least, double most) {
    return Curve{row(e).id, [e](Settings& s) { s.normal.encoding = e; }, {Wobbles{least, most}}};
  };
  return {curve(E::oct8, 3, 12),      curve(E::xyz8, 2.7, 11),   curve(E::bestfit8, 0.85, 3.4),
          curve(E::xyz10, 0.65, 2.7), curve(E::oct12, 0.3, 1.2), curve(E::oct14, 0.08, 0.35),
          curve(E::oct16, 0, 0.15),   curve(E::xyz32f, 0, 0.1)};
}

}  // namespace

Sweep normal_angle_sweep() {
  return {.id = "normal-angle",
          .label = "Normals from the pole -Z to +Z",
          .parameter = "angle of the normal to -Z",
          .unit = "degrees",
          .log_axis = true,
          .metric = "normal_deg_max",
          .help = "a wall in strips whose normals stand at this angle, all around; 180: no direction came back",
          .values = angles_deg,
          .curves = encoding_curves,
          .at = normals_at};
}

Sweep roughness_sweep() {
  return {.id = "roughness",
          .label = "Highlights from smooth to matte",
          .parameter = "roughness",
          .unit = "",
          .log_axis = true,
          .metric = "max_linear",
          .help =
              "a black, glossy dome under one light, exponents from roughness (8192 below 0.125, where the highlight's "
              "peak is 41): the smoother, the more a normal's code shows",
          .values = roughnesses,
          .curves = roughness_curves,
          .at = dome_of};
}

Sweep sub_pixel_pan_sweep() {
  return {.id = "sub-pixel-pan",
          .label = "A highlight while the camera pans",
          .parameter = "camera moved to the right",
          .unit = "pixels",
          .log_axis = false,
          .metric = "peak_off",
          .help =
              "a black, glossy dome under one light, an eighth of a pixel from frame to frame: a coarse normal's "
              "highlight flickers, since its brightest point jumps from code to code",
          .values = pans_px,
          .curves = pan_curves,
          .at = dome_seen_from};
}

}  // namespace gbl
