#pragma once
// The cheapest set-up for what the window shows, looked for while the window goes on: what the advisor asks is measured
// in slices with targets of its own, and only while nothing else wants the machine.
#include "app/advice_bench.h"
#include "app/advice_job.h"
#include "app/background.h"

namespace gbl {

class BackgroundAdvice : public BackgroundJob {
 public:
  explicit BackgroundAdvice(Lab&);

  void update(const Settings& now, const ui::Requests&, bool quiet) override;
  bool busy() const override { return job_ != nullptr; }
  void forget() override;
  void fill(ui::Input& in) const override { in.advisor = &shown_; }

 private:
  void start(const Settings& now, const ui::AdvisorRequest&);
  void stop(std::string why);
  void work();
  bool step();
  void finish();

  Lab& lab_;
  std::shared_ptr<const GpuScene> scene_;
  std::optional<AdviceBench> bench_;  // while it runs
  std::unique_ptr<AdviceJob> job_;
  std::optional<AdviceJob::Question> measured_;  // by the bench
  Settings truth_;                               // of the one that runs, or else of the answer
  ErrorBudget budget_;
  AdviceCost cost_ = AdviceCost::bytes;
  std::string note_;  // what became of the one that ran last
  ui::AdvisorInput shown_;
};

}  // namespace gbl
