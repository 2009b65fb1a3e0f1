#pragma once
// Failures are judged by the reference in double precision, the broken settings and the fixed ones alike: a failure that
// both share, or a code path that has gone wrong in both, is not hidden by comparing them with each other.
#include "app/truth_keeper.h"
#include "renderer/truth/measure.h"
#include "tests/gl_fixture.h"

namespace gbl::test {

// The reference of these settings in this scene. Only the truth of settings is looked at: broken and fixed share one.
inline std::shared_ptr<const TruthSet> truth_of(const Settings& s, const GpuScene& scene) {
  static std::map<const GpuScene*, TruthKeeper> keepers;
  TruthKeeper& keeper = keepers.try_emplace(&scene, 4, all_processors()).first->second;
  return keeper.get(shared_stage(scene).renderer, scene, s, true);
}

inline Errors errors_of(const Settings& s, const GpuScene& scene) {
  const auto set = truth_of(s, scene);
  Stage& stage = shared_stage(scene);
  stage.draw(s);
  return measure(set->truth, read_drawn(stage.renderer, s, scene, stage.targets, true), {s.exposure, s.colour});
}

// Pixels that are brighter or darker than the truth by more than `codes` of 255 in some channel, as displayed.
struct Compared {
  int brighter = 0, darker = 0;
  int both() const { return brighter + darker; }
};
inline Compared against_truth(const Settings& s, const GpuScene& scene, double codes = 1) {
  const auto set = truth_of(s, scene);
  Stage& stage = shared_stage(scene);
  stage.draw(s);
  const Picture shown =
      picture_of(stage.targets.canvases.shown(stage.targets.frame));  // with what is drawn forward, after lighting
  const Display display{s.exposure, s.colour};
  Compared out;
  for (size_t i = 0; i < shown.count(); ++i) {
    const size_t width = static_cast<size_t>(shown.size.x), from_top = shown.count() / width - 1 - i / width;
    const glm::dvec3 expected = displayed(display, set->truth.lit[from_top * width + i % width]);
    const glm::dvec3 d = displayed(display, glm::vec3(shown.texels[i])) - expected;
    out.brighter += std::max({d.x, d.y, d.z}) > codes / 255;
    out.darker += std::min({d.x, d.y, d.z}) < -codes / 255;
  }
  return out;
}

}  // namespace gbl::test
