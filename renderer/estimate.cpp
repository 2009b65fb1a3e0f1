#include "renderer/estimate.h"

#include <algorithm>
#include <cmath>

#include "renderer/light_volume.h"

namespace gbl {
namespace {

constexpr double kTestCost = 0.4;  // of a distance test against shading; llvmpipe, 64 lights at 1280x720

// Share of the picture under a sphere's silhouette, as if centred: area of its tangent cone, 1 from inside.
double covered_share(const Settings& s, const Light& light, double scale) {
  const glm::dvec3 to_light = light.position - s.camera.position;
  const double d = glm::length(to_light), r = light.range * scale;
  if (d <= r * 1.01) return 1;
  if (glm::dot(to_light, s.camera.forward()) < -r) return 0;
  const double half_height =
      s.camera.orthographic() ? s.camera.orthographic_height / 2 / d : std::tan(glm::radians(s.camera.fov) / 2);
  const double tangent = r / std::sqrt(d * d - r * r);
  const double aspect = double(s.size.x) / s.size.y;
  return std::min(1.0, 3.14159265 * tangent * tangent / (4 * half_height * half_height * aspect));
}

}  // namespace

double estimate_work(const Settings& s, const std::vector<Light>& lights) {
  const double pixels = double(s.size.x) * s.size.y;
  const double scale = volume_scale(s, VolumeShape::sphere);
  double under_volumes = 0;
  for (const Light& l : lights) under_volumes += covered_share(s, l, scale);
  switch (s.lights.method) {
    case LightMethod::forward:
    case LightMethod::forward_prepass:
    case LightMethod::forward_multipass: return pixels * double(lights.size());
    case LightMethod::prepass:
    case LightMethod::fullscreen: return pixels * double(lights.size());
    case LightMethod::fullscreen_radius: return pixels * (kTestCost * double(lights.size()) + under_volumes);
    case LightMethod::volumes_stencil: return pixels * under_volumes;  // at most: what is not inside is not shaded
    case LightMethod::volumes_instanced:
    case LightMethod::volumes: return pixels * under_volumes * (s.lights.cull == LightCull::none ? 2 : 1);
  }
  return 0;
}

// First guesses, kept only until the first frame: 6 ns is llvmpipe on two cores, 0.05 ns a small GPU.
FrameCost::FrameCost(bool software) : ns_per_unit_(software ? 6 : 0.05), ns_per_pixel_(software ? 60 : 1) {}

void FrameCost::learn(double work, double lighting_ms) {
  if (work < 1e5 || !(lighting_ms > 0)) return;  // too little to learn from
  ns_per_unit_ = 0.5 * ns_per_unit_ + 0.5 * lighting_ms * 1e6 / work;
}

double FrameCost::predict_ms(const Settings& s, const std::vector<Light>& lights) const {
  return (estimate_work(s, lights) * ns_per_unit_ + double(s.size.x) * s.size.y * ns_per_pixel_) * 1e-6;
}

glm::ivec2 FrameCost::affordable_size(const Settings& s, const std::vector<Light>& lights, double budget_ms) const {
  const double predicted = predict_ms(s, lights);
  if (predicted <= budget_ms) return s.size;
  const double smallest = 64.0 / std::min(s.size.x, s.size.y);
  const double shrink = std::min(1.0, std::max(smallest, std::sqrt(std::max(0.0, budget_ms) / predicted)));
  return glm::ivec2(glm::dvec2(s.size) * shrink + 1e-6);  // 64 stays 64 after its two roundings
}

}  // namespace gbl
