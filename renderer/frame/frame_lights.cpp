#include "renderer/frame/frame_lights.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/light/attenuation.h"
#include "renderer/light/lights.h"
#include "renderer/scenes/rig.h"

namespace gbl {
namespace {

std::vector<Light> from_source(const Settings& s, const Scene& scene) {
  if (s.lights.source == LightSource::scene) return scene.lights;
  if (s.lights.source == LightSource::rig) return rig_lights(s.lights.rig);
  if (scene.light_box) return generated_lights(*scene.light_box, s.lights.count, s.lights.seed);
  return generated_lights(scene.light_grid, s.lights.count, s.lights.seed, s.time_s);
}

constexpr size_t kShaderArray = 16;  // of Mistake::silent_light_cap: MAX_LIGHTS of tutorial 9

double brightest(const Light& l) { return std::max({l.colour.x, l.colour.y, l.colour.z}); }

// Where its radiance on white falls to 1/255 of the display's white: by its own falloff x + y d + z d^2, else by the
// inverse square. Endless where it never gets there.
double faint_at(const Light& l, double exposure) {
  const glm::dvec3 k = l.coefficients == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : l.coefficients;
  const double rest = 255 * exposure * brightest(l) - k.x;
  if (rest <= 0) return 0;
  if (k.z > 0) return 2 * rest / (k.y + std::sqrt(k.y * k.y + 4 * k.z * rest));
  return k.y > 0 ? rest / k.y : kEndless;
}

// Where the light ends, by range.kind; its falloff stays a function of the range that it came with.
void set_range(Light& l, const Settings& s) {
  const bool stated = !l.ends_faint;
  if (!stated) l.range = faint_at(l, s.exposure);
  if (l.range < kEndless) l.range *= s.lights.range_scale;
  // Of an inverse square without a stated range nothing is taken away before its end.
  l.profile_range = !stated && s.attenuation == Attenuation::gltf ? kEndless : l.range;
  if (l.kind == LightKind::directional) return;
  if (s.range.kind == RangeKind::none) l.range = kEndless;
  if (s.range.kind != RangeKind::threshold || l.coefficients != glm::dvec3(0)) return;
  const bool shortcut = s.mistakes.count(Mistake::range_shortcut) > 0;
  l.range = shortcut ? range_by_shortcut(brightest(l), l.range, s.range.threshold)
                     : range_at_threshold(s.attenuation, brightest(l), l.range, s.range.threshold);
}

// Without an edge: the exponent stands where the inner cone's cosine did.
void open_cone(Light& l) {
  const double cosine = std::clamp(l.outer_cos, 1e-3, 1 - 1e-9);
  l.inner_cos = std::clamp(std::log(0.05) / std::log(cosine), 1.0, 1e4);
  l.outer_cos = -1;
}

void require_finite(const std::vector<Light>& lights) {
  for (size_t i = 0; i < lights.size(); ++i) {
    const Light& l = lights[i];
    double sum = l.range + l.inner_cos + l.outer_cos;
    for (int k = 0; k < 3; ++k) sum += l.position[k] + l.colour[k] + l.direction[k] + l.coefficients[k];
    if (!std::isfinite(sum))
      throw Error(ExitCode::bad_input, "lights", fmt::format("light {} holds a number that is not finite", i),
                  "fix its position, colour, range, direction or falloff in the scene or rig");
  }
}

}  // namespace

std::vector<Light> all_lights_of(const Settings& s, const Scene& scene) {
  std::vector<Light> lights = from_source(s, scene);
  // An inverse square of unit intensity is dark a few units away: generated lights are made bright for their range.
  const bool inverse_square = s.attenuation == Attenuation::windowed || s.attenuation == Attenuation::gltf;
  if (inverse_square && s.lights.source == LightSource::generated)
    for (Light& l : lights) l.colour *= l.range * l.range / 16;
  for (Light& l : lights) {
    set_range(l, s);
    if (l.kind == LightKind::spot && s.lights.spot == LightSpot::cos_power) open_cone(l);
  }
  require_finite(lights);
  if (s.mistakes.count(Mistake::silent_light_cap) > 0) lights.resize(std::min(lights.size(), kShaderArray));
  if (s.lights.first >= 0) lights.resize(std::min<size_t>(lights.size(), s.lights.first));
  return lights;
}

std::vector<Light> lights_of(const Settings& s, const Scene& scene) {
  std::vector<Light> lights = all_lights_of(s, scene);
  if (s.lights.only < 0) return lights;
  if (s.lights.only >= static_cast<int>(lights.size())) return {};
  return {lights[static_cast<size_t>(s.lights.only)]};
}

}  // namespace gbl
