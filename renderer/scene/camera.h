#pragma once
// The camera, in double. World is right-handed, Y up, metres; at identity it looks along -Z.
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace gbl {

struct Camera {
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};  // world from view; unit length. (GLM's constructor takes w first)
  double fov = 45;                     // vertical, degrees; unused when orthographic
  double orthographic_height = 0;      // 0 = perspective, else the height of the picture in world units
  double near = 1;                     // distances along the view axis; 0 < near < far
  double far = 10000;
  // Width : height that is shown whole, as a file's camera asks: a narrower picture shows more above and below.
  // 0 = the height alone counts.
  double aspect = 0;
  bool operator==(const Camera&) const = default;

  bool orthographic() const { return orthographic_height > 0; }
  // Of a picture of this shape, in world units at distance 1 along the view axis; of an orthographic camera anywhere.
  double half_height(double picture_aspect) const;
  glm::dvec3 forward() const { return orientation * glm::dvec3(0, 0, -1); }
  glm::dvec3 right() const { return orientation * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return orientation * glm::dvec3(0, 1, 0); }
};

// yaw 0 looks along -Z, positive turns left; positive pitch looks up. Degrees.
glm::dquat orientation_from_yaw_pitch(double yaw_deg, double pitch_deg);
glm::dvec2 yaw_pitch_of(const glm::dquat& orientation);  // {yaw, pitch} in degrees

// How depth runs. Standard: window depth 0 near, 1 far; clip z in -w..w, as GL's. Reversed: 1 near, 0 far; clip z in
// 0..w (Reed 2015, "Depth Precision Visualized").
enum class DepthRuns { standard, reversed };

// Clip space: x and y in -w..w, z as DepthRuns says.
glm::dmat4 clip_from_view(const Camera&, double aspect, DepthRuns = DepthRuns::standard);

// "Relative" = world axes, origin at the camera: small numbers even 10^7 units from the world's origin.
glm::dmat4 clip_from_relative(const Camera&, double aspect, DepthRuns = DepthRuns::standard);

// A surface point relative to the camera is
//   perspective:   range * (forward + x * right + y * up)      x, y = normalised device coordinates, -1..1
//   orthographic:  range * forward + x * right + y * up
// where range = distance along the view axis in world units.
struct ViewRays {
  glm::dvec3 forward, right, up;  // right and up are already scaled by the picture's half extents
};
ViewRays view_rays(const Camera&, double aspect);

// Window depth 0..1 -> distance along the view axis, and back.
double range_from_depth(const Camera&, double depth, DepthRuns = DepthRuns::standard);
double depth_from_range(const Camera&, double range, DepthRuns = DepthRuns::standard);

// Distance from the camera to a corner of the near plane, as a factor of `near`:
// sqrt(1 + tan^2(fov/2) (1 + aspect^2)); 1.309 at 45 degrees and 16:9.
double near_corner_factor(const Camera&, double aspect);

}  // namespace gbl
