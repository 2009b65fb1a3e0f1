#include "app/truth_keeper.h"

#include <algorithm>

#include "renderer/gl/device.h"

namespace gbl {

std::shared_ptr<const TruthSet> TruthKeeper::get(Renderer& renderer, const GpuScene& scene, const Settings& s,
                                                 bool wait) {
  const Settings wanted = witness_of(s);
  const auto found =
      std::find_if(sets_.begin(), sets_.end(), [&](const auto& set) { return same_truth(set->settings, wanted); });
  if (found != sets_.end()) {
    maker_.reset();
    return *found;
  }
  if (!maker_ || !same_truth(maker_->settings(), wanted)) maker_ = std::make_unique<TruthMaker>(s, threads_);
  std::shared_ptr<const TruthSet> set = maker_->step(renderer, scene, wait);
  if (!set) return nullptr;
  maker_.reset();
  sets_.push_front(set);
  if (sets_.size() > kept_) sets_.pop_back();
  return set;
}

void TruthKeeper::forget() {
  maker_.reset();
  sets_.clear();
}

}  // namespace gbl
