#include "renderer/scene/framing.h"

#include <algorithm>

namespace gbl {
namespace {

constexpr double kNearest = 1e-6;  // a scene that is one point still has a size to stand away from

// How far a scene reaches beyond the planes of a frustum whose apex is the origin: the largest right - slope * ahead
// and its like on the other three sides. The apex that has all of them at its planes is found without a search.
struct Reach {
  double right = -INFINITY, left = -INFINITY, up = -INFINITY, down = -INFINITY;
  double nearest = INFINITY;
};

Reach reach_of(const Scene& scene, const Camera& camera, const glm::dvec3& middle, double slope) {
  Reach reach;
  const glm::dquat view_from_world = glm::conjugate(camera.orientation);
  visit_points(scene, [&](const glm::dvec3& world) {
    const glm::dvec3 p = view_from_world * (world - middle);
    const double ahead = slope * -p.z;
    reach.right = std::max(reach.right, p.x - ahead), reach.left = std::max(reach.left, -p.x - ahead);
    reach.up = std::max(reach.up, p.y - ahead), reach.down = std::max(reach.down, -p.y - ahead);
    reach.nearest = std::min(reach.nearest, -p.z);
  });
  return reach;
}

}  // namespace

Camera framed(const Scene& scene, Camera camera, double part) {
  camera.aspect = 1;  // a square of the picture is shown whole: its shorter side counts
  const glm::dvec3 middle = scene.bounds.centre();
  const double radius = std::max(glm::length(scene.bounds.extent()) / 2, kNearest);
  const double slope = part * camera.half_height(1);
  glm::dvec3 eye(0, 0, radius / slope);  // about the middle, along the view's axes
  const Reach reach = reach_of(scene, camera, middle, slope);
  if (reach.nearest < INFINITY) {
    const double back = std::max(reach.right + reach.left, reach.up + reach.down) / (2 * slope);
    const double clear = 0.02 * radius - reach.nearest;  // what is seen edge on or as a needle is in front, too
    eye = {(reach.right - reach.left) / 2, (reach.up - reach.down) / 2,
           std::max({back, clear, kNearest - reach.nearest})};
  }
  camera.position = middle + camera.orientation * eye;
  camera.near = radius * 0.01;
  camera.far = std::max(eye.z, 0.0) + 4 * radius;
  return camera;
}

}  // namespace gbl
