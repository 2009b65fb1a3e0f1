// Sweeps of light: a sum of ever fainter terms, and a light cut off ever fainter.
#include <fmt/format.h>

#include "renderer/light/attenuation.h"
#include "renderer/study/stability/stability_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

// ---- light-count ----------------------------------------------------------------------------------------------------

constexpr double kSum = 0.25;  // of all lights together, where they face the wall

std::vector<double> light_counts() { return {1, 2, 4, 8, 16, 32, 64, 100, 128, 192, 256, 512, 1024, 2048, 4096}; }

// The same light split among ever more lamps at one place: every picture should be the same.
SweepSetup light_split(double count) {
  const auto n = static_cast<size_t>(count);
  SweepSetup setup = wall_setup(fmt::format("sweep:light-count/{}", n), {64, 36}, wall_at({0, 0, -10}, 30),
                                std::vector<Light>(n, lamp({0, 0, 5}, 60, kSum / count)));
  Settings& s = setup.settings;
  s.attenuation = Attenuation::none;
  s.camera.far = 100;
  s.lights.method = LightMethod::volumes_instanced;  // a blend per light
  s.lights.cull = LightCull::front;
  s.lights.volume.level = VolumeLevel::l0;
  return setup;
}

Curve sum_curve(AccumulationFormat f, Expected expected) {
  return {row(f).id, [f](Settings& s) { s.accumulation.format = f; }, {expected}};
}

std::vector<Curve> light_count_curves(const DeviceRounding& rounding) {
  using F = AccumulationFormat;
  const bool half_truncates = rounding.half_blend == StoreRounding::toward_zero;
  const bool r11_truncates = rounding.r11 == StoreRounding::toward_zero;
  return {
      sum_curve(F::rgba8, Diverges{.up_to = 8, .from = 192, .holds = 0.01, .fails = 0.99}),
      sum_curve(F::r11g11b10f, r11_truncates ? Diverges{.up_to = 8, .from = 64, .holds = 0.04, .fails = 0.2}
                                             : Diverges{.up_to = 32, .from = 256, .holds = 0.04, .fails = 0.2}),
      sum_curve(F::rgba16f, half_truncates ? Diverges{.up_to = 32, .from = 512, .holds = 0.01, .fails = 0.08}
                                           : Diverges{.up_to = 512, .from = 4096, .holds = 0.01, .fails = 0.08}),
      sum_curve(F::rgba32f, Flat{1e-4}),
  };
}

// ---- range-threshold ------------------------------------------------------------------------------------------------

std::vector<double> thresholds() {
  return {1e-4, 2e-4, 3e-4, 3.3e-4, 3.5e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 5.0 / 256, 0.05, 0.1, 0.2, 0.5};
}

// The wall cuts the light at nine tenths of its range and all is scaled with the range: the rim is the same circle in
// every picture, lit from 26 degrees off the normal, and only its brightness changes.
SweepSetup cut_at(double threshold) {
  const double range = range_at_threshold(Attenuation::quadratic, 1, 1, threshold);
  SweepSetup setup = wall_setup(fmt::format("sweep:range-threshold/{}", threshold), {160, 90},
                                wall_at({0, 0, -0.9 * range}, 3 * range), {lamp({0, 0, 0}, range)});
  Settings& s = setup.settings;
  s.attenuation = Attenuation::quadratic;
  s.range = {RangeKind::threshold, threshold};
  s.camera.position = {0, 0, 0.55 * range};
  s.camera.near = 0.1 * range, s.camera.far = 10 * range;
  return setup;
}

std::vector<Curve> range_threshold_curves(const DeviceRounding&) {
  const auto as_tutorial = [](Settings& s) { s.colour = Colour::as_tutorial; };
  const auto windowed = [](Settings& s) { s.range.kind = RangeKind::windowed; };
  // 0.9 = cosine at the rim. sRGB begins with a slope of 12.92: one code at 1 / (0.9 x 12.92 x 255) = 3.37e-4.
  return {
      {"colour=srgb",
       [](Settings&) {},
       {Diverges{.up_to = 3.3e-4, .from = 3.5e-4, .holds = 1, .fails = 1},
        Diverges{.up_to = 3.3e-4, .from = 5.0 / 256, .holds = 1, .fails = 35}}},
      {"colour=as-tutorial",
       as_tutorial,
       {Grows{.slope = 1, .tolerance = 0.02, .at = 0.01, .low = 2.2, .high = 2.4, .spread = 1.1}}},
      {"range.kind=windowed", windowed, {Flat{1}}},
  };
}

}  // namespace

Sweep light_count_sweep() {
  return {.id = "light-count",
          .label = "The same light split among ever more lamps",
          .parameter = "number of lights",
          .unit = "",
          .log_axis = true,
          .metric = "mean_off",
          .help = "N lamps at one place, each 0.25 / N, blended one by one: formats with few bits drop what is faint",
          .values = light_counts,
          .curves = light_count_curves,
          .at = light_split};
}

Sweep range_threshold_sweep() {
  return {.id = "range-threshold",
          .label = "A light cut off where it gets faint",
          .parameter = "threshold at which a light ends",
          .unit = "radiance",
          .log_axis = true,
          .metric = "rim_step",
          .help = "the step at the rim where a light is cut off: an edge of the model, not an error of a method",
          .values = thresholds,
          .curves = range_threshold_curves,
          .at = cut_at,
          .keeps = {"attenuation", "range.kind", "range.threshold"}};
}

}  // namespace gbl
