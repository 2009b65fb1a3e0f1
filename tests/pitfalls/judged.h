#pragma once
// Failures are judged by the reference in double precision, the broken settings and the fixed ones alike: a failure that
// both share, or a code path that has gone wrong in both, is not hidden by comparing them with each other.
#include "app/truth_keeper.h"
#include "renderer/base/threads.h"
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

}  // namespace gbl::test
