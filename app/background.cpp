#include "app/background.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/background_advice.h"
#include "app/background_pitfall.h"
#include "app/background_study.h"
#include "app/background_sweep.h"
#include "app/pitfall_pictures.h"
#include "renderer/base/error.h"

namespace gbl {

static constexpr double kMostFrameMs = 1500;

std::vector<std::unique_ptr<BackgroundJob>> background_jobs(Lab& lab) {
  std::vector<std::unique_ptr<BackgroundJob>> jobs;
  jobs.push_back(std::make_unique<BackgroundPitfall>(lab));
  jobs.push_back(std::make_unique<PitfallPictures>(lab));
  jobs.push_back(std::make_unique<BackgroundSweep>(lab));
  jobs.push_back(std::make_unique<BackgroundAdvice>(lab));
  jobs.push_back(std::make_unique<BackgroundStudy>(lab));
  return jobs;
}

Settings as_measured(Settings s) {
  s.size = kBackgroundSize;
  s.view = {};
  return s;
}

void require_quick(const Settings& s, Lab& lab, const char* where, const char* fix) {
  const Settings witness = witness_of(s);
  const double ms = std::max(lab.cost().predict_ms(*lab.resolve(s)), lab.cost().predict_ms(*lab.resolve(witness)));
  if (ms > kMostFrameMs)
    throw Error(ExitCode::unfinished, where,
                fmt::format("predicted {:.1f} s a frame: the window would stand still", ms / 1000), fix);
}

}  // namespace gbl
