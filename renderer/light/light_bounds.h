#pragma once
// Where on the screen a light can light anything. A proxy contains its volume; if in doubt it is larger.
#include <glm/glm.hpp>

#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct Ball {
  glm::dvec3 centre{0};
  double radius = 0;
};

// A ball round all that a bounded light reaches; of a narrow spot light it is smaller than its range.
Ball reach_of(const Light&);

// Right, up and distance along the view axis of a world position.
glm::dvec3 view_of(const Camera&, const glm::dvec3& world);

struct Interval {
  double from, to;
  bool empty() const { return !(from < to); }
};

// Of a circle that a perspective camera at the origin sees, the part at depth >= nearest: bounds of c / depth.
// `c` is the centre's distance sideways, `depth` its distance along the view axis.
Interval slopes_of_circle(double c, double depth, double radius, double nearest);

// In normalised device coordinates; `clipped` keeps -1..1.
struct ScreenBounds {
  glm::dvec2 from{0}, to{0};
  bool empty() const { return !(from.x < to.x && from.y < to.y); }
  double area() const { return empty() ? 0 : (to.x - from.x) * (to.y - from.y); }
};
ScreenBounds clipped(const ScreenBounds&);

// Exact bounds of the part of a ball beyond the near plane; empty if there is none.
ScreenBounds screen_bounds(const Camera&, double aspect, const Ball&);
// The same of a ball whose centre is as view_of() gives it; `half`: the picture's half extents, as Camera::half_height().
ScreenBounds view_bounds(const Camera&, glm::dvec2 half, const glm::dvec3& centre, double radius);

// Of all that a light reaches, clipped; the whole screen for a light without end.
ScreenBounds screen_bounds(const Camera&, double aspect, const Light&);

}  // namespace gbl
