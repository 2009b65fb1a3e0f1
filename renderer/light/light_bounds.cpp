#include "renderer/light/light_bounds.h"

#include <algorithm>
#include <cmath>

#include "renderer/light/light_volume.h"

namespace gbl {
namespace {

constexpr double kRounding = 1e-9;  // of normalised device coordinates: far above double's, far below a pixel

ScreenBounds perspective_bounds(const Camera& c, glm::dvec2 half, const glm::dvec3& at, double radius) {
  const Interval x = slopes_of_circle(at.x, at.z, radius, c.near);
  const Interval y = slopes_of_circle(at.y, at.z, radius, c.near);
  return {{x.from / half.x, y.from / half.y}, {x.to / half.x, y.to / half.y}};
}

ScreenBounds orthographic_bounds(const Camera& c, glm::dvec2 half, const glm::dvec3& at, double radius) {
  // What the near plane leaves of a ball whose centre is behind it is as wide as the cut.
  const double cut = std::max(0.0, c.near - at.z);
  const double width = std::sqrt(std::max(0.0, radius * radius - cut * cut));
  return {(glm::dvec2(at) - width) / half, (glm::dvec2(at) + width) / half};
}

}  // namespace

Ball reach_of(const Light& l) {
  if (l.kind != LightKind::spot || l.outer_cos <= 0) return {l.position, l.range};
  // Through the apex and the rim while the cone is narrow, else round the rim alone.
  const double outer_sin = std::sqrt(std::max(0.0, 1 - l.outer_cos * l.outer_cos));
  const bool narrow = l.outer_cos > outer_sin;
  const double along = narrow ? l.range / (2 * l.outer_cos) : l.range * l.outer_cos;
  return {l.position + along * l.direction, narrow ? along : l.range * outer_sin};
}

glm::dvec3 view_of(const Camera& c, const glm::dvec3& world) {
  const glm::dvec3 v = glm::conjugate(c.orientation) * (world - c.position);
  return {v.x, v.y, -v.z};
}

// Mara and McGuire 2013, "2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere": the tangents from the
// eye, and where a tangent touches nearer than `nearest`, the end of the chord that this plane cuts.
Interval slopes_of_circle(double c, double depth, double radius, double nearest) {
  if (depth + radius <= nearest) return {0, 0};
  const double half_chord = std::sqrt(std::max(0.0, radius * radius - (nearest - depth) * (nearest - depth)));
  const double squared_distance = c * c + depth * depth;
  const double squared_tangent = squared_distance - radius * radius;
  const auto bound = [&](double side) {
    if (squared_tangent > 0) {
      const double tangent = std::sqrt(squared_tangent);
      const double along = depth * tangent - side * c * radius;  // direction of the tangent, not yet of unit length
      const bool seen = along * tangent >= nearest * squared_distance;
      if (seen) return (c * tangent + side * depth * radius) / along;
    }
    return (c + side * half_chord) / nearest;
  };
  return {bound(-1), bound(1)};
}

ScreenBounds clipped(const ScreenBounds& b) {
  const ScreenBounds inside{glm::max(b.from, -1.0), glm::min(b.to, 1.0)};
  return inside.empty() ? ScreenBounds{} : inside;
}

ScreenBounds view_bounds(const Camera& c, glm::dvec2 half, const glm::dvec3& at, double radius) {
  if (!(radius > 0) || at.z + radius <= c.near) return {};
  ScreenBounds b =
      c.orthographic() ? orthographic_bounds(c, half, at, radius) : perspective_bounds(c, half, at, radius);
  b.from -= kRounding, b.to += kRounding;
  return b;
}

ScreenBounds screen_bounds(const Camera& c, double aspect, const Ball& ball) {
  return view_bounds(c, c.half_height(aspect) * glm::dvec2(aspect, 1), view_of(c, ball.centre), ball.radius);
}

ScreenBounds screen_bounds(const Camera& c, double aspect, const Light& l) {
  if (!bounded(l)) return {{-1, -1}, {1, 1}};
  return clipped(screen_bounds(c, aspect, reach_of(l)));
}

}  // namespace gbl
