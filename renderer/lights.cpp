#include "renderer/lights.h"

#include <algorithm>
#include <cmath>

#include "renderer/random.h"

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

std::vector<Light> lights_of(const Settings& s, const Scene& scene) {
  std::vector<Light> lights = generated_lights(scene.light_grid, s.lights.count, s.lights.seed, s.time_s);
  for (Light& l : lights) l.range *= s.lights.range_scale;
  if (s.lights.first >= 0) lights.resize(std::min<size_t>(lights.size(), s.lights.first));
  if (s.lights.only >= 0) {
    if (s.lights.only >= static_cast<int>(lights.size())) return {};
    lights = {lights[s.lights.only]};
  }
  return lights;
}

}  // namespace gbl
