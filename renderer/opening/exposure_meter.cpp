#include "renderer/opening/exposure_meter.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/threads.h"
#include "renderer/truth/reference.h"
#include "renderer/truth/visible_triangles.h"

namespace gbl {
namespace {

// Of the lit pixels this part is shown at kShown or darker, as radiance 0..1: highlights and the hot spots beside lamps
// are the rest, and ambient light has room above it.
constexpr double kPart = 0.95, kShown = 0.7;
constexpr double kMostPairs = 4e6;  // (pixel, light): a second at most
constexpr int kWidest = 48;         // pixels
constexpr double kLeast = 1e-6, kMost = 1e6;

double third_of_a_stop(double exposure) { return std::exp2(std::round(3 * std::log2(exposure)) / 3); }

// A small picture of the same shape.
glm::ivec2 metered_size(const glm::ivec2& size, size_t lights) {
  const double aspect = double(size.x) / size.y;
  const double pixels = std::min<double>(kWidest * kWidest / aspect, kMostPairs / double(std::max<size_t>(lights, 1)));
  const double height = std::sqrt(std::max(pixels, 100.0) / aspect);
  return {std::clamp(static_cast<int>(height * aspect), 1, 16 * kWidest),
          std::clamp(static_cast<int>(height), 1, 16 * kWidest)};
}

// Without an end that depends on the exposure: what is looked for must not decide what is found.
Settings metered(const Settings& s, const Scene& scene) {
  Settings m = s;
  m.exposure = kMost;
  m.view = {};
  m.size = metered_size(s.size, true_lights(m, scene).size());
  return m;
}

double brightest(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); }

}  // namespace

std::optional<double> metered_exposure(const Settings& s, const Scene& scene) {
  const Settings m = metered(s, scene);
  const std::shared_ptr<const Scene> borrowed(std::shared_ptr<const Scene>(), &scene);
  Reference reference(m, borrowed, visible_triangles(m, scene));
  reference.run(all_processors());
  const Truth& truth = reference.truth();
  std::vector<double> lit;
  for (size_t i = 0; i < truth.pixels(); ++i)
    if (const double light = brightest(truth.light(i)); truth.present[i] && light > 0 && std::isfinite(light))
      lit.push_back(light);
  if (lit.empty()) return {};
  const auto at = lit.begin() + static_cast<long>(kPart * double(lit.size() - 1));
  std::nth_element(lit.begin(), at, lit.end());
  return std::clamp(third_of_a_stop(kShown / *at), kLeast, kMost);
}

void set_exposure(Settings& s, double exposure) {
  const double share = s.exposure / exposure;
  s.exposure = exposure;
  s.ambient = std::min(s.ambient * share, 1e6);
  s.background.colour = glm::min(s.background.colour * share, glm::dvec3(1e6));
}

bool meter(Settings& s, const Scene& scene) {
  const std::optional<double> exposure = metered_exposure(s, scene);
  if (exposure) set_exposure(s, *exposure);
  return exposure.has_value();
}

}  // namespace gbl
