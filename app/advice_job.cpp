#include "app/advice_job.h"

#include "renderer/base/error.h"

namespace gbl {

AdviceJob::AdviceJob(const Settings& truth, std::shared_ptr<const Scene> scene, const ErrorBudget& budget,
                     AdviceCost cost, const DeviceLimits& limits)
    : thread_([=, this, scene = std::move(scene)] { run(truth, *scene, budget, cost, limits); }) {}

AdviceJob::~AdviceJob() {
  {
    const std::lock_guard lock(mutex_);  // not between the thread's look at cancel_ and its sleep
    cancel_ = true;
  }
  answered_.notify_all();
  thread_.join();
}

AdviceJob::Answer AdviceJob::ask(Question q) {
  std::unique_lock lock(mutex_);
  question_ = std::move(q);
  answer_.reset();
  answered_.wait(lock, [this] { return cancel_ || answer_; });
  question_.reset();
  if (cancel_) throw Error(ExitCode::interrupted, "advice", "stopped");
  if (const auto* e = std::get_if<std::exception_ptr>(&*answer_)) std::rethrow_exception(*e);
  return *answer_;
}

void AdviceJob::run(const Settings& truth, const Scene& scene, const ErrorBudget& budget, AdviceCost cost,
                    const DeviceLimits& limits) {
  const JudgeFn judge = [this](const Settings& s, int camera) { return std::get<BoundCheck>(ask({s, camera})); };
  const CostFn measure = [this](const Settings& s) { return std::get<double>(ask({s, {}})); };
  const AdviceProgress progress = [this](const std::string& what) {
    const std::lock_guard lock(mutex_);
    progress_ = what;
    ++tried_;
  };
  Advice found;
  std::exception_ptr error;
  try {
    found = advise(truth, scene, budget, cost, limits, judge, measure, progress, cancel_);
  } catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  advice_ = std::move(found), error_ = error, finished_ = true;
}

std::optional<AdviceJob::Question> AdviceJob::question() const {
  const std::lock_guard lock(mutex_);
  return answer_ ? std::nullopt : question_;
}

void AdviceJob::answer(Answer a) {
  {
    const std::lock_guard lock(mutex_);
    answer_ = std::move(a);
  }
  answered_.notify_all();
}

bool AdviceJob::finished() const {
  const std::lock_guard lock(mutex_);
  return finished_;
}

Advice AdviceJob::advice() {
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(error_);
  return advice_;
}

size_t AdviceJob::tried() const {
  const std::lock_guard lock(mutex_);
  return tried_;
}

std::string AdviceJob::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

}  // namespace gbl
