#include "renderer/inspect/view_legends.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/gbuffer/layouts.h"
#include "renderer/light/light_methods.h"

namespace gbl {
namespace {

glm::vec3 grey(double g) { return glm::vec3(static_cast<float>(g)); }

constexpr int kBarSteps = 4;

}  // namespace

// Dark to light with each luminance at least 1.6 times the one before (plus 0.05, the projector's glare): the order
// survives colour blindness, a grey print and a bright room. The hues are there to be named aloud.
const glm::vec3 kLightCountPalette[kLightCountColours] = {
    {0.04f, 0.04f, 0.06f}, {0.16f, 0.22f, 0.62f}, {0.05f, 0.46f, 0.55f},
    {0.30f, 0.68f, 0.25f}, {0.98f, 0.76f, 0.15f}, {1.00f, 1.00f, 1.00f},
};

double round_for_bar(double x) {
  const double decade = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {1.0, 1.2, 1.6, 2.0, 2.4, 3.2, 4.0, 6.0, 8.0})
    if (step * decade >= x) return step * decade;
  return 10 * decade;
}

double position_cycle(const Bounds& bounds) {
  const double extent = std::max(1e-9, glm::length(bounds.extent()));
  return std::pow(10.0, std::floor(std::log10(extent / 10)));
}

glm::dvec2 depth_view_range(const Camera& camera, const Bounds& bounds) {
  double farthest = camera.near;  // a scene behind the camera still needs a bar
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                       corner & 4 ? bounds.max.z : bounds.min.z);
    farthest = std::max(farthest, glm::dot(p - camera.position, camera.forward()));
  }
  return {0, std::min(round_for_bar(farthest), camera.far)};
}

Legend depth_legend(const Settings& s, const Bounds& bounds) {
  const glm::dvec2 range = depth_view_range(s.camera, bounds);
  Legend bar{true, {}, {{"sky", kSkyColour}}};
  for (int i = 0; i <= kBarSteps; ++i) {
    const double t = static_cast<double>(i) / kBarSteps;
    bar.entries.push_back(
        {fmt::format("{:g}{}", range.x + t * (range.y - range.x), i < kBarSteps ? "" : " units"), grey(t)});
  }
  return bar;
}

Legend material_legend(const Settings& s, const Bounds&) {
  if (facts(s.layout).shows == MaterialView::specular && shading_of(s.lights.method) == Shading::deferred)
    return {false, {{"colour of the highlight", grey(0.5)}}, {}};
  Legend bar{true, {}, {}};
  for (int i = 0; i <= kBarSteps; ++i) {
    const double roughness = static_cast<double>(i) / kBarSteps;
    std::string label = fmt::format("{:g}", roughness);
    if (s.shading.exponent == kExponentFromRoughness) {
      const double exponent = std::clamp(2 / std::pow(roughness, 4) - 2, 1.0, 8192.0);
      label += fmt::format(" ({}{:.0f})", i == 0 ? "exponent " : "", exponent);
    }
    bar.entries.push_back({label, grey(roughness)});
  }
  return bar;
}

Legend normal_legend(const Settings&, const Bounds&) {
  Legend axes;
  for (const float sign : {1.0f, -1.0f})
    for (int k = 0; k < 3; ++k) {
      glm::vec3 n(0);
      n[k] = sign;
      axes.entries.push_back({fmt::format("{}{}", sign > 0 ? '+' : '-', "XYZ"[k]), n * 0.5f + 0.5f});
    }
  return axes;
}

Legend count_legend(const Settings&, const Bounds&) {
  Legend counts;
  for (int i = 0; i < kLightCountColours; ++i)
    counts.entries.push_back({fmt::format("{}{}", i, i + 1 < kLightCountColours ? "" : "+"), kLightCountPalette[i]});
  return counts;
}

Legend wasted_legend(const Settings&, const Bounds&) {
  Legend counts;
  for (int i = 0; i < kLightCountColours; ++i) {
    const int from = kWastedFrom[i], to = i + 1 < kLightCountColours ? kWastedFrom[i + 1] - 1 : from;
    const std::string label = i + 1 == kLightCountColours ? fmt::format("{}+", from)
                              : from == to                ? fmt::format("{}", from)
                                                          : fmt::format("{}-{}", from, to);
    counts.entries.push_back({label, kLightCountPalette[i]});
  }
  return counts;
}

Legend position_legend(const Settings&, const Bounds& bounds) {
  return {false,
          {{"red: x", {1, 0, 0}},
           {"green: y", {0, 1, 0}},
           {"blue: z", {0, 0, 1}},
           {fmt::format("one colour cycle = {:g} units", position_cycle(bounds)), grey(0.5)}},
          {}};
}

}  // namespace gbl
