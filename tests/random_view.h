#pragma once
// Random directions, cameras and the like for tests that claim something of all of them.
#include <cmath>
#include <glm/glm.hpp>

#include "renderer/base/random.h"
#include "renderer/scene/camera.h"

namespace gbl {

inline glm::dvec3 random_direction(Pcg32& random) {
  for (;;) {
    const glm::dvec3 v(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
    if (glm::length(v) > 0.01 && glm::length(v) <= 1) return glm::normalize(v);
  }
}

inline Camera random_camera(Pcg32& random, bool orthographic) {
  Camera c;
  c.position = random_direction(random) * random.in(0, 50);
  c.orientation = orientation_from_yaw_pitch(random.in(-180, 180), random.in(-90, 90));
  c.fov = random.in(10, 120);
  c.near = random.in(0.01, 3);
  c.far = random.in(30, 3000);
  if (orthographic) c.orthographic_height = random.in(1, 100);
  return c;
}

inline double largest(const glm::dvec2& v) { return std::max(v.x, v.y); }

}  // namespace gbl
