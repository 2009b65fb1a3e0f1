#include "renderer/light/lights.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "renderer/base/random.h"

namespace gbl {

std::vector<Light> generated_lights(const LightGrid& grid, int count, unsigned seed, double time_s) {
  std::vector<Light> lights;
  lights.reserve(count);
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  // Corner to corner, as source 0; its spacing divides by side - 1, which one light must not.
  const auto place = [&](int i, double extent) { return side > 1 ? extent / (side - 1) * i : extent / 2; };
  const double angle = glm::radians(grid.degrees_per_s * time_s);  // from absolute time: no drift
  const double c = std::cos(angle), s = std::sin(angle);
  Pcg32 random(seed);
  for (int i = 0; i < count; ++i) {
    const double x = place(i / side, grid.extent.x) - grid.pivot.x;
    const double z = place(i % side, grid.extent.y) - grid.pivot.y;
    Light light;
    light.position = {grid.pivot.x + c * x + s * z, grid.height, grid.pivot.y - s * x + c * z};
    for (int k = 0; k < 3; ++k) light.colour[k] = random.in(0.5, 1.5);
    light.range = grid.extent.x / side;
    lights.push_back(light);
  }
  return lights;
}

namespace {

double box_range(const LightBox& box, int count, const glm::dvec3& colour) {
  switch (box.rule) {
    case BoxRange::fixed: return box.range;
    case BoxRange::overlap: {
      const glm::dvec3 e = box.max - box.min;
      return std::cbrt(3 * box.overlap * e.x * e.y * e.z / (4 * glm::pi<double>() * count));
    }
    case BoxRange::quadratic: {
      // 1.8 r^2 + 0.7 r + 1 - 256/5 * brightest = 0; a light too dim to reach the threshold anywhere has no range.
      const double c = 1 - 256.0 / 5 * std::max({colour.x, colour.y, colour.z});
      return c < 0 ? (-0.7 + std::sqrt(0.49 - 7.2 * c)) / 3.6 : 0;
    }
  }
  return 0;
}

}  // namespace

std::vector<Light> generated_lights(const LightBox& box, int count, unsigned seed) {
  std::vector<Light> lights(count);
  Pcg32 random(seed);
  for (Light& l : lights) {
    for (int k = 0; k < 3; ++k) l.position[k] = random.in(box.min[k], box.max[k]);
    for (int k = 0; k < 3; ++k) l.colour[k] = random.in(box.colour_min, box.colour_max);
    l.range = box_range(box, count, l.colour);
  }
  return lights;
}

}  // namespace gbl
