#include "renderer/study/advice/sight_advice.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "renderer/frame/frame_lights.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/study/advice/axis_values.h"

namespace gbl {
namespace {

constexpr int kMostShadows = 16;  // lights: more are not tried

struct SightAxis {
  Patch alone;       // over the lossless set-up: what is true but for this
  Values values;     // cheapest first
  const char* what;  // "shadow maps", for sentences
};

template <class E>
Values each(const char* path) {
  Values out;
  for (const ValueRow& r : rows<E>()) out.push_back({{path, r.id}});
  return out;
}

Values light_counts(int lights) {
  Values out;
  for (int n = 0; n < lights; n += n < 4 ? 1 : n / 2) out.push_back({{"shadow.max-lights", n}});
  out.push_back({{"shadow.max-lights", lights}});
  return out;
}

Values mirrors() {
  Values out{{{"reflect.method", "cube"}, {"reflect.size", "256"}}};
  for (const ValueRow& r : rows<ReflectSize>()) out.push_back({{"reflect.method", "planar"}, {"reflect.size", r.id}});
  return out;
}

Values parallaxes() {
  Values out{{{"parallax.method", "offset"}}};
  for (const int steps : {8, 16, 32, 64, 128, 256})
    out.push_back({{"parallax.method", "occlusion"}, {"parallax.steps", steps}});
  return out;
}

int shadowed_lights(const Settings& truth, const Scene& scene) {
  const std::vector<Light> lights = lights_of(truth, scene);
  const auto is_sun = [](const Light& l) { return l.kind == LightKind::directional; };
  return static_cast<int>(truth.shadows == Shadows::all ? static_cast<long>(lights.size())
                                                        : std::count_if(lights.begin(), lights.end(), is_sun));
}

std::vector<SightAxis> sight_axes(const Settings& truth, const Scene& scene) {
  std::vector<SightAxis> out;
  const int lights = truth.shadows == Shadows::off ? 0 : shadowed_lights(truth, scene);
  if (lights > 0) {
    const int most = std::min(lights, kMostShadows);
    const Assignment on{"shadows", row(truth.shadows).id};
    out.push_back({{on, {"shadow.max-lights", most}}, each<ShadowMapSize>("shadow.map-size"), "shadow maps"});
    out.push_back({{on}, light_counts(most), "lights with shadows"});
  }
  if (truth.reflections != Reflections::off) out.push_back({{{"reflections", "on"}}, mirrors(), "mirrors"});
  if (truth.height_map != HeightMap::off) out.push_back({{{"height-map", "on"}}, parallaxes(), "height maps"});
  return out;
}

// Maps too large for all lights to have one are no answer: the error would be that of the missing ones.
class RoomForMaps {
 public:
  RoomForMaps(const Scene& scene, const DeviceLimits& limits) : scene_(scene), limits_(limits) {}
  bool leaves_more_out(const Settings& s) {
    const int without = resolve_frame(s, scene_, limits_.features).shadows.without;
    return without > least_.try_emplace(s.shadow.max_lights, without).first->second;
  }

 private:
  const Scene& scene_;
  const DeviceLimits& limits_;
  std::map<int, int> least_;  // of each shadow.max-lights: lights without a map where maps are smallest
};

// Empty: this device draws none of the values.
std::optional<SightChoice> choose(const SightAxis& axis, const Settings& base, const ErrorBudget& budget,
                                  const DeviceLimits& limits, RoomForMaps& room, const WorstFn& worst) {
  SightChoice out;
  double least = 1;
  for (const Patch& value : axis.values) {
    Settings s = base;
    apply_values(s, value);
    if (!validate(s, limits).empty() || room.leaves_more_out(s)) continue;
    out.tried.push_back(worst(value, s));
    least = std::min(least, out.tried.back().worst.share_over());
  }
  if (out.tried.empty()) return std::nullopt;
  const double bound = least <= budget.share_over ? budget.share_over : least + budget.share_over;
  while (out.tried[out.taken].worst.share_over() > bound) ++out.taken;  // the best one is within it
  return out;
}

std::string over_bound(const Tried& t) {
  return fmt::format("{}: {:.3g} % of the pixels are over the bound from camera {}", in_words(t.values),
                     100 * t.worst.share_over(), t.camera);
}

}  // namespace

SightAdvice advise_sights(const Settings& truth, const Settings& lossless, const Scene& scene,
                          const ErrorBudget& budget, const DeviceLimits& limits, const WorstFn& worst) {
  SightAdvice out;
  RoomForMaps room(scene, limits);
  if (truth.shadows != Shadows::off && shadowed_lights(truth, scene) > kMostShadows)
    out.left_out.push_back(fmt::format("shadow.max-lights above {}: not tried", kMostShadows));
  for (const SightAxis& axis : sight_axes(truth, scene)) {
    Settings base = lossless;
    apply_values(base, axis.alone);
    if (!out.chosen.empty()) apply_values(base, out.chosen);
    std::optional<SightChoice> choice = choose(axis, base, budget, limits, room, worst);
    if (!choice) continue;
    for (size_t i = 0; i < choice->taken; ++i) out.left_out.push_back(over_bound(choice->tried[i]));
    const Tried& taken = choice->tried[choice->taken];
    if (!taken.holds)
      out.left_out.push_back(fmt::format("{}; no more of {} brings that down by more than {:g} %", over_bound(taken),
                                         axis.what, 100 * budget.share_over));
    out.chosen.insert(out.chosen.end(), taken.values.begin(), taken.values.end());
    out.choices.push_back(std::move(*choice));
  }
  return out;
}

}  // namespace gbl
