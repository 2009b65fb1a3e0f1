// Sweeps of positions: the distance to the surface, to the world's origin, to the near plane.
#include <fmt/format.h>

#include "renderer/gbuffer/position_source.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/study/stability/stability_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kSize{96, 54};

using S = PositionSource;
using R = PositionReconstruct;
using D = DepthFormat;

Curve position_curve(const PositionRow& r, std::vector<Expected> expected) {
  return {id_of(r),
          [=](Settings& s) {
            s.position = {r.source, r.reconstruct};
            s.depth.format = r.source == S::depth ? r.format : D::d32f;
          },
          std::move(expected)};
}
Curve depth_curve(R reconstruct, D format, std::vector<Expected> expected) {
  return position_curve({S::depth, reconstruct, format, {}}, std::move(expected));
}
Curve stored_curve(S source, std::vector<Expected> expected) {
  return position_curve({source, R::view_ray, D::d32f, {}}, std::move(expected));
}

// ---- view-distance --------------------------------------------------------------------------------------------------

std::vector<double> view_distances() { return {1.2, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 9000}; }

Camera source_0_camera() {
  Camera c;  // turned so that no axis is special
  c.position = {2056, 500, 4112};
  c.orientation = orientation_from_yaw_pitch(35, -12);
  c.near = 1, c.far = 10000;
  return c;
}

SweepSetup wall_at_distance(const std::string& name, const Camera& camera, double distance) {
  SweepSetup setup = wall_setup(name, kSize, wall_before(camera, distance), {lamp(camera.position, 4 * distance)});
  setup.settings.camera = camera;
  return setup;
}

SweepSetup view_distance_at(double distance) {
  return wall_at_distance(fmt::format("sweep:view-distance/{}", distance), source_0_camera(), distance);
}

std::vector<Curve> view_distance_curves(const DeviceRounding&) {
  const auto square = [](double low, double high) {
    return Grows{.slope = 2, .tolerance = 0.1, .from = 50, .at = 1000, .low = low, .high = high};
  };
  const auto straight = [](double low, double high) {
    return Grows{.slope = 1, .tolerance = 0.1, .from = 10, .at = 1000, .low = low, .high = high};
  };
  // Nearer than 5 all is exact, beyond 2000 a step of the depth reaches the far plane.
  const Grows coarse{.slope = 2, .tolerance = 0.1, .from = 5, .to = 2000, .at = 1000, .low = 5, .high = 20};
  // Beyond 2000 the depth's own square takes over.
  const Grows inverse{.slope = 1, .tolerance = 0.1, .from = 10, .to = 2000, .at = 1000, .low = 0.3, .high = 1.5};
  return {
      depth_curve(R::view_ray, D::d16, {coarse}),
      depth_curve(R::view_ray, D::d24, {square(0.02, 0.3)}),
      depth_curve(R::view_ray, D::d32f, {square(0.02, 0.3)}),
      depth_curve(R::view_ray, D::d32f_reversed, {straight(1e-4, 1e-3)}),
      depth_curve(R::inverse_viewproj, D::d24, {inverse}),
      depth_curve(R::inverse_viewproj, D::d32f, {inverse}),
      stored_curve(S::linear32f, {straight(1e-4, 1e-3)}),
      stored_curve(S::world16f, {Flat{6}}),
      stored_curve(S::world32f, {Flat{5e-3}}),
      stored_curve(S::view16f, {straight(0.2, 2)}),
      stored_curve(S::view32f, {straight(1e-4, 1e-3)}),
      stored_curve(S::view_scaled, {Flat{0.06}}),
  };
}

// ---- world-offset ---------------------------------------------------------------------------------------------------

std::vector<double> world_offsets() { return {1, 10, 100, 1000, 3000, 1e4, 3e4, 6e4, 1e5, 3e5, 1e6, 1e7}; }

// Ground, a wall and a box, 20 units from the camera, with four lights; all of it moved along X. Nothing is round: at a
// ball's outline a pixel sees so flat an angle that the rasteriser's own rounding hides the rest.
SweepSetup yard_at(double offset) {
  auto scene = std::make_shared<Scene>();
  scene->name = fmt::format("sweep:world-offset/{}", offset);
  scene->meshes = {make_box({-30, -1, -15}, {30, 0, 10}, 1), make_box({-30, 0, -16}, {30, 12, -15}, 1),
                   make_box({-6, 0, -4}, {-2, 4, 0}, 1)};
  scene->materials = {{.name = "white"}};
  const auto place = [&](const char* name, int mesh, const glm::dvec3& at) {
    glm::dmat4 m(1);
    m[3] = glm::dvec4(at + glm::dvec3(offset, 0, 0), 1);
    scene->instances.push_back({name, mesh, 0, m});
  };
  place("ground", 0, {0, 0, 0}), place("wall", 1, {0, 0, 0}), place("box", 2, {0, 0, 0});
  for (const double x : {-9.0, -3.0, 3.0, 9.0}) scene->lights.push_back(lamp({offset + x, 3, 2}, 6));
  scene->bounds = bounds_of(*scene);
  SweepSetup setup{exact_settings(scene->name, kSize), scene};
  setup.settings.camera.position = {offset, 6, 20};
  setup.settings.camera.orientation = orientation_from_yaw_pitch(0, -12);
  setup.settings.camera.near = 1, setup.settings.camera.far = 100;
  return setup;
}

// What the rasteriser's own rounding leaves at this distance.
constexpr double kFloor = 5e-4;

std::vector<Curve> world_offset_curves(const DeviceRounding&) {
  const auto with_offset = [](double from, double to, double at, double low, double high) {
    return Grows{
        .slope = 1, .tolerance = 0.15, .from = from, .to = to, .at = at, .low = low, .high = high, .spread = 3};
  };
  const Grows inverse = with_offset(1000, kNoEnd, 1e5, 0.05, 1);
  return {
      depth_curve(R::view_ray, D::d24, {Flat{kFloor}}),
      depth_curve(R::view_ray, D::d32f_reversed, {Flat{kFloor}}),
      depth_curve(R::inverse_viewproj, D::d32f, {inverse}),
      depth_curve(R::inverse_viewproj_varying, D::d32f, {inverse}),
      stored_curve(S::linear32f, {Flat{kFloor}}),
      stored_curve(S::world16f, {with_offset(100, 6e4, 1000, 0.2, 1.2), Diverges{6e4, 1e5, 64, 3e4}}),
      stored_curve(S::world32f, {with_offset(1e4, kNoEnd, 1e5, 0.002, 0.012), Diverges{3000, 3e4, kFloor, kFloor}}),
      stored_curve(S::view16f, {Flat{0.05}}),
      stored_curve(S::view32f, {Flat{kFloor}}),
      stored_curve(S::view_scaled, {Flat{0.06}}),
  };
}

// ---- near-plane -----------------------------------------------------------------------------------------------------

std::vector<double> near_planes() { return {1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1, 3, 10}; }

SweepSetup near_plane_at(double near) {
  Camera camera = source_0_camera();
  camera.near = near;
  return wall_at_distance(fmt::format("sweep:near-plane/{}", near), camera, 100);
}

std::vector<Curve> near_plane_curves(const DeviceRounding&) {
  const auto inverse = [](double from, double low, double high) {
    return Grows{.slope = -1, .tolerance = 0.1, .from = from, .at = 1, .low = low, .high = high};
  };
  return {
      depth_curve(R::view_ray, D::d16, {inverse(0.1, 0.05, 0.2)}),
      depth_curve(R::view_ray, D::d24, {inverse(1e-3, 3e-4, 4e-3)}),
      depth_curve(R::view_ray, D::d32f, {inverse(1e-3, 3e-4, 4e-3)}),
      depth_curve(R::view_ray, D::d32f_reversed, {Flat{1e-4}}),
  };
}

// ---- depth-decode ---------------------------------------------------------------------------------------------------

SweepSetup depth_decode_at(double distance) {
  return wall_at_distance(fmt::format("sweep:depth-decode/{}", distance), source_0_camera(), distance);
}

// A few roundings of a float: of the quotient, of the ray, of their product.
constexpr double kFewRoundings = 4e-7;

// Not of 24 bits: a code is no float, and to round it to one loses up to half a code before any formula reads it.
std::vector<Curve> depth_decode_curves(const DeviceRounding&) {
  const Flat exact{kFewRoundings};
  return {
      depth_curve(R::view_ray, D::d16, {exact}),
      depth_curve(R::view_ray, D::d32f, {exact}),
      depth_curve(R::view_ray, D::d32f_reversed, {exact}),
  };
}

}  // namespace

Sweep view_distance_sweep() {
  return {.id = "view-distance",
          .label = "Positions of a wall near and far",
          .parameter = "distance of the wall",
          .unit = "units",
          .log_axis = true,
          .metric = "position_max",
          .help =
              "near 1, far 10000, the camera at (2056, 500, 4112): depth that is not reversed loses with the square "
              "of the distance",
          .values = view_distances,
          .curves = view_distance_curves,
          .at = view_distance_at};
}

Sweep world_offset_sweep() {
  return {.id = "world-offset",
          .label = "The whole scene moved from the origin",
          .parameter = "offset of scene and camera along X",
          .unit = "units",
          .log_axis = true,
          .metric = "position_max",
          .help =
              "a yard 20 units before the camera: what is stored relative to the camera does not see the offset, "
              "world positions and float inverses do, and half floats end at 65504",
          .values = world_offsets,
          .curves = world_offset_curves,
          .at = yard_at};
}

Sweep near_plane_sweep() {
  return {.id = "near-plane",
          .label = "The near plane comes closer",
          .parameter = "near plane",
          .unit = "units",
          .log_axis = true,
          .metric = "position_max",
          .help = "a wall 100 units away, far 10000: without reversing, float depth is no better than 24 bits",
          .values = near_planes,
          .curves = near_plane_curves,
          .at = near_plane_at,
          .keeps = {"camera.near"}};
}

Sweep depth_decode_sweep() {
  return {.id = "depth-decode",
          .label = "From stored depth to a distance",
          .parameter = "distance of the wall",
          .unit = "units",
          .log_axis = true,
          .metric = "decode_off",
          .help =
              "near 1, far 10000: whatever the format has lost, the formula that reads it loses no more than a few "
              "roundings; one that cancels loses by itself",
          .values = view_distances,
          .curves = depth_decode_curves,
          .at = depth_decode_at};
}

}  // namespace gbl
