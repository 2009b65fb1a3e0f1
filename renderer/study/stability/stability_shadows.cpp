// Sweeps of shadow maps.
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {
namespace {

std::vector<double> biases() { return {0.0625, 0.125, 0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}; }

std::shared_ptr<const Scene> stage() {
  Scene scene = build_bias();
  scene.name = "sweep:shadow-bias";
  return std::make_shared<const Scene>(std::move(scene));
}

// Stairs, thin boards and slopes under a sun, a lamp and a spot, all but the shadows exact. The truth is one for all points.
SweepSetup biased_by(double texels) {
  static const std::shared_ptr<const Scene> scene = stage();
  Settings s;
  s.scene = scene->name;
  s.size = {160, 90};
  s.camera = scene->camera;
  s.lights.source = LightSource::scene;
  s.lights.method = LightMethod::fullscreen;
  s.layout = Layout::float32, s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::view32f;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
  s.attenuation = Attenuation::windowed;
  s.shading.model = ShadingModel::lambert;
  s.shadows = Shadows::all;
  s.shadow.bias = texels, s.shadow.slope_bias = 0;
  return {s, scene};
}

std::vector<Curve> bias_curves(const DeviceRounding&) {
  const auto slope = [](Settings& s) { s.shadow.slope_bias = 1.5; };
  const auto front = [](Settings& s) { s.shadow.cull = ShadowCull::front; };
  const auto wide = [](Settings& s) { s.shadow.filter = ShadowFilter::pcf3; };
  // Ends: acne on the left; on the right shadows that stand apart by a fifth of a board's height.
  return {
      {"slope-bias=0",
       [](Settings&) {},
       {Least{.from = 1.5, .to = 4, .most = 100, .ends = 300},
        FailsIn{.from = 0.0625, .to = 0.5, .beyond = 1.5, .holds = 500, .fails = 3000}}},
      {"slope-bias=1.5", slope, {FailsIn{.before = 8, .from = 48, .to = 64, .holds = 110, .fails = 250}}},
      {"cull=front", front, {Least{.from = 1, .to = 3, .most = 105, .ends = 180}}},
      {"filter=3x3", wide, {Least{.from = 3, .to = 8, .most = 190, .ends = 350}}},
  };
}

}  // namespace

Sweep shadow_bias_sweep() {
  return {.id = "shadow-bias",
          .label = "Too little bias and too much",
          .parameter = "bias towards the light",
          .unit = "texels",
          .log_axis = true,
          .metric = "shadow_wrong_pixels",
          .help =
              "stairs, boards and slopes: surfaces that hide themselves on the left, shadows that stand apart on the "
              "right, and the "
              "least sum of both between",
          .values = biases,
          .curves = bias_curves,
          .at = biased_by,
          .keeps = {"shadows", "shadow.bias", "shadow.slope-bias"}};
}

}  // namespace gbl
