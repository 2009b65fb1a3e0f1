#include "renderer/study/advice/sight_advice.h"

#include <algorithm>
#include <fmt/format.h>

namespace gbl {
namespace {

// Of every light a map or six: more than so many are no teaching machine's business.
constexpr int kMostShadows = 16;

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

}  // namespace

std::vector<SightAxis> sight_axes(const Settings& truth, int lights) {
  std::vector<SightAxis> out;
  if (truth.shadows != Shadows::off && lights > 0) {
    const int most = std::min(lights, kMostShadows);
    const Assignment on{"shadows", row(truth.shadows).id};
    out.push_back({{on, {"shadow.max-lights", most}}, each<ShadowMapSize>("shadow.map-size"), "shadow maps"});
    out.push_back({{on},
                   light_counts(most),
                   lights > most ? "lights with shadows (16 at most are tried)" : "lights with shadows"});
  }
  if (truth.reflections != Reflections::off) out.push_back({{{"reflections", "on"}}, mirrors(), "mirrors"});
  if (truth.height_map != HeightMap::off) out.push_back({{{"height-map", "on"}}, parallaxes(), "height maps"});
  return out;
}

SightChoice choose_sight(const SightAxis& axis, const Settings& lossless, const std::vector<Assignment>& chosen,
                         const ErrorBudget& budget, const DeviceLimits& limits, const WorstFn& judge) {
  SightChoice out;
  Settings base = lossless;
  apply_values(base, axis.alone);
  if (!chosen.empty()) apply_values(base, chosen);
  double least = 1;
  for (const Patch& value : axis.values) {
    Settings s = base;
    apply_values(s, value);
    if (!validate(s, limits).empty()) continue;
    std::optional<Tried> tried = judge(value, s);
    if (!tried) continue;
    out.tried.push_back(std::move(*tried));
    least = std::min(least, out.tried.back().worst.share_over());
  }
  const double bound = least <= budget.share_over ? budget.share_over : least + budget.share_over;
  const auto near_enough = [&](const Tried& t) { return t.worst.share_over() <= bound; };
  const auto taken = std::find_if(out.tried.begin(), out.tried.end(), near_enough);
  out.taken = static_cast<size_t>(taken - out.tried.begin());
  return out;
}

std::vector<std::string> in_sentences(const SightAxis& axis, const SightChoice& choice, const ErrorBudget& budget) {
  std::vector<std::string> out;
  const auto over = [](const Tried& t) {
    return fmt::format("{:.3g} % of the pixels are over the bound from camera {}", 100 * t.worst.share_over(),
                       t.camera);
  };
  for (size_t i = 0; i < choice.taken; ++i)
    out.push_back(fmt::format("{}: {}", in_words(choice.tried[i].values), over(choice.tried[i])));
  const Tried& taken = choice.tried[choice.taken];
  if (!taken.holds)
    out.push_back(fmt::format("{}: {}; no more of {} brings that down by more than {:g} %", in_words(taken.values),
                              over(taken), axis.what, 100 * budget.share_over));
  return out;
}

}  // namespace gbl
