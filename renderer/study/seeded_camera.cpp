#include "renderer/study/seeded_camera.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/random.h"
#include "renderer/truth/scene_rays.h"

namespace gbl {
namespace {

constexpr double kYaw = 60, kPitch = 15;           // degrees to either side
constexpr double kNearest = 0.6, kFarthest = 1.4;  // of the own camera's distance
constexpr double kSteepest = 85;                   // degrees: beyond it yaw has no meaning
constexpr int kTries = 64;
constexpr int kColumns = 5, kRows = 3;  // of the grid of rays
constexpr double kAspect = 16.0 / 9;    // of the picture that the rays cover
constexpr double kCloseUp = 0.05;       // of the distance: what is nearer than this fills the picture

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

glm::dquat looking_along(const glm::dvec3& forward) {
  const double pitch = std::asin(std::clamp(forward.y, -1.0, 1.0));
  return orientation_from_yaw_pitch(glm::degrees(std::atan2(-forward.x, -forward.z)), glm::degrees(pitch));
}

// Along the own camera's axis to the depth of the scene's centre; if that lies behind it, half the scene's size.
double distance_to_target(const Scene& scene, const Camera& own) {
  const double to_centre = glm::dot(scene.bounds.centre() - own.position, own.forward());
  if (to_centre > own.near) return to_centre;
  return std::max(glm::length(scene.bounds.extent()) / 2, 2 * own.near);
}

bool inside(const Bounds& b, const glm::dvec3& p) {
  return glm::all(glm::greaterThan(p, b.min)) && glm::all(glm::lessThan(p, b.max));
}

Camera candidate(const Bounds& bounds, const Camera& own, double distance, Pcg32& random) {
  const glm::dvec3 target = own.position + distance * own.forward();
  const glm::dvec2 turn = yaw_pitch_of(own.orientation);
  const double yaw = turn.x + random.in(-kYaw, kYaw);
  const double pitch = std::clamp(turn.y + random.in(-kPitch, kPitch), -kSteepest, kSteepest);
  Camera camera = own;
  camera.orientation = orientation_from_yaw_pitch(yaw, pitch);
  camera.position = target - random.in(kNearest, kFarthest) * distance * camera.forward();
  if (!inside(bounds, own.position)) return camera;
  // Indoors: not through the wall. A fiftieth away from the bounds, for they are the walls.
  const glm::dvec3 margin = 0.02 * bounds.extent();
  camera.position = glm::clamp(camera.position, bounds.min + margin, bounds.max - margin);
  const glm::dvec3 to_target = target - camera.position;
  if (glm::length(to_target) > own.near) camera.orientation = looking_along(glm::normalize(to_target));
  return camera;
}

bool sees_something(const Scene& scene, const Camera& camera, double distance) {
  if (!finite(camera.position)) return false;
  const ViewRays rays = view_rays(camera, kAspect);
  int seen = 0;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const int column = i % kColumns, row = i / kColumns;
    const double x = (2 * column + 1.0) / kColumns - 1, y = (2 * row + 1.0) / kRows - 1;
    const glm::dvec3 across = x * rays.right + y * rays.up;
    const auto hit = camera.orthographic() ? first_hit(scene, camera.position + across, rays.forward)
                                           : first_hit(scene, camera.position, rays.forward + across);
    if (!hit || hit->distance > camera.far) continue;
    if (hit->from_behind || hit->distance < std::max(camera.near, kCloseUp * distance)) return false;
    ++seen;
  }
  return 3 * seen >= kColumns * kRows;
}

}  // namespace

Camera seeded_camera(const Scene& scene, const Camera& own, int k) {
  const double distance = distance_to_target(scene, own);
  if (k <= 0 || !std::isfinite(distance)) return own;
  Pcg32 random(static_cast<uint64_t>(k));
  for (int i = 0; i < kTries; ++i) {
    const Camera camera = candidate(scene.bounds, own, distance, random);
    if (sees_something(scene, camera, distance)) return camera;
  }
  return own;
}

}  // namespace gbl
