#include "renderer/gbuffer/position_source.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>

#include "renderer/base/random.h"

namespace gbl {
namespace {

using S = PositionSource;
using R = PositionReconstruct;
using D = DepthFormat;

// clang-format off
constexpr PositionRow kRows[] = {
  {S::depth, R::view_ray, D::d16, {0.00099, 0.099, 10, 540}},
  {S::depth, R::view_ray, D::d24, {6.2e-06, 0.00039, 0.038, 3.1}},
  {S::depth, R::view_ray, D::d32f, {5.7e-06, 0.00039, 0.038, 3.1}},
  {S::depth, R::view_ray, D::d32f_reversed, {2.6e-06, 2.7e-05, 0.00027, 0.0024}},
  {S::depth, R::inverse_viewproj, D::d24, {0.0058, 0.06, 0.64, 6.9}},
  {S::depth, R::inverse_viewproj, D::d32f, {0.0058, 0.06, 0.64, 6.9}},
  {S::linear32f, R::view_ray, D::d32f, {2.3e-06, 2.1e-05, 0.00022, 0.0021}},
  {S::world16f, R::view_ray, D::d32f, {2.2, 1.4, 1.4, 4}},
  {S::world32f, R::view_ray, D::d32f, {0.00027, 0.00017, 0.00021, 0.00057}},
  {S::view16f, R::view_ray, D::d32f, {0.0044, 0.046, 0.36, 4.5}},
  {S::view32f, R::view_ray, D::d32f, {2.3e-06, 2.3e-05, 0.00021, 0.0023}},
  {S::view_scaled, R::view_ray, D::d32f, {0.044, 0.043, 0.044, 0.045}},
};
// clang-format on

constexpr double kAspect = 16.0 / 9;

Camera camera() {
  Camera c;  // source 0's, turned so that no axis is special
  c.position = {2056, 500, 4112};
  c.orientation = orientation_from_yaw_pitch(35, -12);
  return c;
}

float stored_depth(D f, double depth) {
  const auto fixed = [&](double levels) { return static_cast<float>(std::nearbyint(depth * levels) / levels); };
  if (f == D::d16) return fixed(65535);
  if (f == D::d24) return fixed(16777215);
  return static_cast<float>(depth);
}

glm::vec3 as_half(const glm::vec3& v) {
  glm::vec3 out;
  for (int k = 0; k < 3; ++k) out[k] = glm::unpackHalf1x16(glm::packHalf1x16(v[k]));
  return out;
}

glm::vec3 by_view_ray(const SurfacePixel& p, float range) {
  const ViewRays rays = view_rays(p.camera, p.aspect);
  const glm::vec3 sideways = p.ndc.x * glm::vec3(rays.right) + p.ndc.y * glm::vec3(rays.up);
  if (p.camera.orthographic()) return range * glm::vec3(rays.forward) + sideways;
  return range * (glm::vec3(rays.forward) + sideways);
}

// As shaders/position.glsl, in float.
float range_from_stored(const Camera& c, DepthRuns runs, float depth) {
  const auto near = static_cast<float>(c.near), far = static_cast<float>(c.far);
  const float from_far = runs == DepthRuns::reversed ? depth : 1.0f - depth;
  if (c.orthographic()) return far - from_far * (far - near);
  return near * far / (near + from_far * (far - near));
}

glm::vec3 from_depth(const PositionRow& r, const SurfacePixel& p) {
  const Camera& c = p.camera;
  const DepthRuns runs = depth_runs(r.format);
  if (r.reconstruct == R::view_ray) return by_view_ray(p, range_from_stored(c, runs, p.window_depth));
  const glm::mat4 view_from_world = glm::mat4(glm::mat4_cast(glm::conjugate(c.orientation))) *
                                    glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0),
                                              glm::vec4(-glm::vec3(c.position), 1));
  const glm::mat4 world_from_clip = glm::inverse(glm::mat4(clip_from_view(c, p.aspect, runs)) * view_from_world);
  const float ndc_depth = runs == DepthRuns::reversed ? p.window_depth : p.window_depth * 2.0f - 1.0f;
  const glm::vec4 world = world_from_clip * glm::vec4(p.ndc, ndc_depth, 1.0f);
  return glm::vec3(world) / world.w - glm::vec3(c.position);
}

glm::vec3 restored(const PositionRow& r, const SurfacePixel& p) {
  constexpr float kViewScale = 1.0e6f;
  const Camera& c = p.camera;
  const glm::mat3 view_from_world(glm::mat3_cast(glm::conjugate(c.orientation)));
  const glm::vec3 relative(p.relative), origin(c.position), view = view_from_world * relative;
  switch (r.source) {
    case S::depth: return from_depth(r, p);
    case S::linear32f: return by_view_ray(p, static_cast<float>(glm::dot(p.relative, c.forward())));
    case S::world16f: return as_half(relative + origin) - origin;
    case S::world32f: return (relative + origin) - origin;
    case S::view16f: return as_half(view) * view_from_world;
    case S::view32f: return view * view_from_world;
    case S::view_scaled: return ((view / kViewScale + 0.5f) - 0.5f) * kViewScale * view_from_world;
  }
  return {};
}

}  // namespace

std::span<const PositionRow> position_rows() { return kRows; }

glm::dvec3 position_read(const PositionRow& r, const SurfacePixel& p) { return restored(r, p); }

DepthRuns depth_runs(D f) { return f == D::d32f_reversed ? DepthRuns::reversed : DepthRuns::standard; }

std::string id_of(const PositionRow& r) {
  if (r.source != S::depth) return row(r.source).id;
  return fmt::format("{}/{}/{}", row(r.source).id, row(r.format).id, row(r.reconstruct).id);
}

double largest_position_error(const PositionRow& r, double range) {
  const Camera c = camera();
  const ViewRays rays = view_rays(c, kAspect);
  Pcg32 random(5);
  double largest = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 160; ++x) {
      const glm::vec2 ndc{(2 * x + 1) / 160.0f - 1, (2 * y + 1) / 90.0f - 1};
      const double at = range * random.in(0.99, 1.01);
      const glm::dvec3 truth = at * (rays.forward + double(ndc.x) * rays.right + double(ndc.y) * rays.up);
      const float depth = stored_depth(r.format, depth_from_range(c, at, depth_runs(r.format)));
      largest = std::max(largest, glm::distance(position_read(r, {c, kAspect, ndc, truth, depth}), truth));
    }
  return largest;
}

}  // namespace gbl
