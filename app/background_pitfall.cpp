#include "app/background_pitfall.h"

namespace gbl {

void BackgroundPitfall::forget() {
  known_.clear();
  shown_ = {};
  entry_.reset();
  bench_.reset();
}

// One side; its reference is made while the window goes on.
void BackgroundPitfall::work() {
  if (!bench_) bench_.emplace(lab_.renderer(), lab_.device());
  const bool broken = !shown_.broken, fixed = broken || !shown_.fixed;
  const PitfallSide side = broken ? PitfallSide::broken : fixed ? PitfallSide::fixed : PitfallSide::blind;
  Settings drawn = settings_of(*entry_, side), meant = truth_of(*entry_, side);
  drawn.size = meant.size = kBackgroundSize;
  require_valid(drawn, bench_->limits());
  const std::optional<PitfallEvidence> e = bench_->try_measure(drawn, meant);
  if (!e) return;
  std::optional<double>& number = broken ? shown_.broken : fixed ? shown_.fixed : shown_.blind;
  number = value_of(pitfall_metric(entry_->metric), *e);
  const bool last = side == PitfallSide::blind || (side == PitfallSide::fixed && !entry_->blind);
  if (number && !last) return;
  if (!number) shown_.note = "cannot be measured in this picture";
  if (last)
    shown_.note =
        judge_numbers(*entry_, bounds_on(*entry_, bench_->rounding()), shown_.broken, shown_.fixed, shown_.blind);
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
