#include "app/advice_bench.h"

#include "app/lab.h"
#include "renderer/study/seeded_camera.h"

namespace gbl {

AdviceBench::AdviceBench(Lab& lab, const ErrorBudget& budget, AdviceCost cost)
    : lab_(lab),
      scene_(lab.gpu_scene()),
      budget_(budget),
      cost_(cost),
      bench_(lab.renderer(), lab.cost(), lab.machine(), kAdviceCameras) {}

// Every one of them is looked for with rays: once is enough.
const Camera& AdviceBench::camera(const Camera& own, int k) {
  if (!(own == own_)) cameras_.clear(), own_ = own;
  while (cameras_.size() <= static_cast<size_t>(k))
    cameras_.push_back(seeded_camera(scene_->scene(), own, static_cast<int>(cameras_.size())));
  return cameras_[static_cast<size_t>(k)];
}

void AdviceBench::start(const Settings& s, BenchWishes wishes) {
  require_valid(s, lab_.limits());
  bench_.start(s, scene_, wishes);
}

void AdviceBench::start_bound(Settings s, int k) {
  s.camera = camera(s.camera, k);
  start(s, {.times = false, .columns = false});
}

void AdviceBench::start_cost(Settings s) {
  s.camera = camera(s.camera, 0);
  start(s, {.errors = false, .times = cost_ == AdviceCost::time});
}

double AdviceBench::cost() const {
  const FrameReport& r = bench_.report();
  return cost_ == AdviceCost::time ? bench_.total_ms() : double(r.pairs->tested + r.pairs->shaded);
}

}  // namespace gbl
