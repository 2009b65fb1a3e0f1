#include "app/background_sweep.h"

#include <fmt/format.h>

#include "app/bench.h"
#include "renderer/base/error.h"

namespace gbl {

void BackgroundSweep::forget() {
  stop();
  runs_.clear();
  chosen_ = nullptr;
  bench_.reset();
  show();
}

BackgroundSweep::Run BackgroundSweep::make_run(const Sweep& s) {
  if (!bench_) bench_.emplace(lab_.renderer(), lab_.device());
  Run run{SweepRunner(s, {.limits = bench_->limits(), .rounding = bench_->rounding()}), {}, {}};
  for (const Curve& c : run.runner.curves()) {
    run.stated.emplace_back();
    for (const Expected& e : c.expected) run.stated.back().push_back(text_of(e, words_of(s)));
  }
  return run;
}

// Goes on where it was stopped; one that is complete is measured anew.
void BackgroundSweep::start() {
  if (chosen_->runner.complete()) {
    const Sweep& s = *chosen_->runner.result().sweep;
    *chosen_ = make_run(s);
  }
  chosen_->failed.clear();
  begun_s_ = now_s(), begun_at_ = chosen_->runner.done();
  if (!chosen_->runner.complete()) running_ = chosen_;  // complete: nothing of it can be drawn here
}

void BackgroundSweep::stop() {
  if (running_) bench_->stop();
  running_ = nullptr;
}

void BackgroundSweep::take(const ui::StabilityRequest& asked) {
  const bool other = !chosen_ || chosen_->runner.result().sweep->id != asked.sweep;
  if (other || asked.stop || !asked.open) stop();
  if (!asked.open) return;
  if (other) {
    const auto [found, made] = runs_.try_emplace(asked.sweep, make_run(sweep(asked.sweep)));
    chosen_ = &found->second;
  }
  if (asked.run) start();
}

// One step of one point. What goes wrong ends the sweep with its reason: the window goes on.
void BackgroundSweep::work() {
  try {
    const std::optional<Measured> m = bench_->try_measure(running_->runner.setup());
    if (!m) return;
    running_->runner.add(*m);
    if (running_->runner.complete()) running_ = nullptr;
  } catch (const std::exception& e) {
    running_->failed = e.what();
    stop();
  }
}

void BackgroundSweep::update(const Settings&, const ui::Requests& requests, bool quiet) {
  const ui::StabilityRequest& asked = requests.stability;
  if (!asked.open && !running_) return;
  try {
    take(asked);
    failed_.clear();
  } catch (const Error& e) {
    failed_ = e.what();
  }
  if (running_ && quiet) work();
  show();
}

void BackgroundSweep::show() {
  shown_ = {};
  shown_.note = failed_;
  if (!chosen_) return;
  const SweepRunner& r = chosen_->runner;
  shown_.result = &r.result();
  shown_.stated = chosen_->stated;
  shown_.done = r.done(), shown_.total = r.total();
  shown_.running = running_ != nullptr;
  if (const size_t measured = r.done() - std::min(r.done(), begun_at_); shown_.running && measured > 0)
    shown_.seconds_left = (now_s() - begun_s_) / double(measured) * double(r.total() - r.done());
  if (!chosen_->failed.empty())
    shown_.note = chosen_->failed;
  else if (!shown_.running && r.done() > 0 && !r.complete())
    shown_.note = fmt::format("Stopped after {} of {} points. R goes on.", r.done(), r.total());
}

}  // namespace gbl
