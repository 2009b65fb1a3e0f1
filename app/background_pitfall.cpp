#include "app/background_pitfall.h"

#include <cmath>

namespace gbl {

void BackgroundPitfall::forget() {
  known_.clear();
  shown_ = {};
  entry_.reset();
  bench_.reset();
}

// NaN: it cannot be measured in this picture.
std::optional<double> BackgroundPitfall::number_of(PitfallSide side, std::optional<double> along) {
  Settings drawn = settings_of(*entry_, side), meant = truth_of(*entry_, side);
  if (along) drawn.camera = meant.camera = camera_on_path(*entry_, *along);
  drawn.size = meant.size = kBackgroundSize;
  require_valid(drawn, bench_->limits());
  const std::optional<PitfallEvidence> e = bench_->try_measure(drawn, meant);
  if (!e) return {};
  return value_of(pitfall_metric(entry_->metric), *e).value_or(std::nan(""));
}

// Broken, fixed, and where it hides.
bool BackgroundPitfall::measure_side() {
  const bool broken = !shown_.broken, fixed = broken || !shown_.fixed;
  const PitfallSide side = broken ? PitfallSide::broken : fixed ? PitfallSide::fixed : PitfallSide::blind;
  (broken ? shown_.broken : fixed ? shown_.fixed : shown_.blind) = number_of(side, {});
  if (!shown_.broken || !shown_.fixed || (entry_->blind && !shown_.blind)) return false;
  shown_.note =
      judge_numbers(*entry_, bounds_on(*entry_, bench_->rounding()), shown_.broken, shown_.fixed, shown_.blind);
  known_[entry_->id] = shown_;  // its path may never be measured to the end
  return true;
}

bool BackgroundPitfall::measure_path() {
  const bool broken = shown_.path_broken.size() == shown_.path_fixed.size();
  std::vector<double>& curve = broken ? shown_.path_broken : shown_.path_fixed;
  const double along = double(curve.size()) / (ui::kPathPoints - 1);
  if (const auto n = number_of(broken ? PitfallSide::broken : PitfallSide::fixed, along)) curve.push_back(*n);
  return shown_.path_fixed.size() == ui::kPathPoints;
}

// A piece; references are made while the window goes on.
void BackgroundPitfall::work() {
  if (!bench_) bench_.emplace(lab_.renderer(), lab_.device());
  const bool judged = shown_.broken && shown_.fixed && (!entry_->blind || shown_.blind);
  if (!judged && (!measure_side() || entry_->path)) return;
  if (judged && !measure_path()) return;
  shown_.running = false;
  known_[entry_->id] = shown_;
}

void BackgroundPitfall::update(const Settings&, const ui::Requests& requests, bool quiet) {
  const std::string& asked = requests.pitfall.id;
  if (asked != shown_.id) {
    if (bench_) bench_->stop();
    entry_.reset();
    const auto kept = known_.find(asked);
    shown_ = kept != known_.end() ? kept->second : ui::PitfallInput{.id = asked, .running = !asked.empty()};
  }
  if (!shown_.running || !quiet) return;
  try {
    if (!entry_) entry_ = load_pitfall(asked);
    work();
  } catch (const std::exception& e) {  // the window goes on
    shown_.note = e.what(), shown_.running = false;
    if (bench_) bench_->stop();
  }
}

}  // namespace gbl
