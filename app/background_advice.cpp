#include "app/background_advice.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/threads.h"
#include "renderer/study/study_here.h"

namespace gbl {
namespace {

constexpr double kSliceSeconds = 0.01;  // a frame goes on with what is asked for so long; steps are much shorter

}  // namespace

BackgroundAdvice::BackgroundAdvice(Lab& lab) : lab_(lab) { shown_.size = kBackgroundSize; }

void BackgroundAdvice::forget() {
  stop("");
  shown_.advice.reset();
}

void BackgroundAdvice::stop(std::string why) {
  job_.reset();
  bench_.reset();
  measured_.reset();
  note_ = std::move(why);
}

void BackgroundAdvice::start(const Settings& now, const ui::AdvisorRequest& asked) {
  stop(kHasThreads ? "" : "The advisor works on a thread of its own, and a page has none: use `gbufferlab advise`.");
  if (!kHasThreads) return;
  if (now.scene != lab_.scene_name()) return;  // it is being read
  truth_ = as_measured(now), budget_ = asked.budget, cost_ = asked.cost;
  bench_.emplace(lab_, budget_, cost_);
  job_ = std::make_unique<AdviceJob>(truth_, scene_->shared_scene(), budget_, cost_, lab_.limits());
}

// A step of what is asked; false: nothing is asked at the moment.
bool BackgroundAdvice::step() {
  try {
    if (!measured_) {
      measured_ = job_->question();
      if (!measured_) return false;
      require_quick(measured_->setup, lab_, "advisor", "ask `gbufferlab advise`");
      if (measured_->camera)
        bench_->start_bound(measured_->setup, *measured_->camera);
      else
        bench_->start_cost(measured_->setup);
    }
    if (!bench_->step(false)) return true;
    job_->answer(measured_->camera ? AdviceJob::Answer(bench_->bound()) : AdviceJob::Answer(bench_->cost()));
  } catch (...) {
    job_->answer(std::current_exception());
  }
  measured_.reset();
  return true;
}

void BackgroundAdvice::work() {
  const double begin = now_s();
  while (step() && now_s() - begin < kSliceSeconds) {
  }
}

void BackgroundAdvice::finish() {
  try {
    shown_.advice = job_->advice();
    shown_.budget = budget_, shown_.cost = cost_;
    stop(shown_.advice->best ? "" : "No set-up holds this budget: even float32 is beyond it somewhere.");
  } catch (const std::exception& e) {
    stop(e.what());
  }
  shown_.running = false;
  shown_.note = note_;
}

void BackgroundAdvice::update(const Settings& now, const ui::Requests& requests, bool quiet) {
  const ui::AdvisorRequest& asked = requests.advisor;
  if (scene_ != lab_.gpu_scene()) {
    scene_ = lab_.gpu_scene();
    forget();
  }
  if (!scene_) return;
  if (job_ && !asked.open) stop("Stopped: the panel was closed. R asks again.");
  if (job_ && asked.stop) stop("Stopped. R asks again.");
  if (asked.open && asked.run) start(now, asked);
  shown_.running = job_ != nullptr;
  shown_.note = note_;
  if (!job_ && !(shown_.advice && asked.open)) return;
  if (const std::string changed = differing_truth(truth_, now, {}); !changed.empty()) {
    if (job_) stop(fmt::format("Stopped: the truth has changed ({}). R asks again.", changed));
    shown_.note =
        note_.empty() ? fmt::format("This answer is of another truth ({} has changed). R asks again.", changed) : note_;
  }
  shown_.running = job_ != nullptr;
  if (!job_) return;
  if (quiet) work();
  shown_.tried = job_->tried(), shown_.progress = job_->progress();
  if (job_->finished()) finish();
}

}  // namespace gbl
