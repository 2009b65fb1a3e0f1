#pragma once
// Stability sweeps while the window goes on: a point a frame, with targets of its own, and only while nothing else
// wants the machine. Sweeps bring scenes and cameras of their own: what the window shows does not matter to them.
#include <map>

#include "app/background.h"
#include "app/stability_bench.h"

namespace gbl {

class BackgroundSweep : public BackgroundJob {
 public:
  explicit BackgroundSweep(Lab& lab) : lab_(lab) {}

  void update(const Settings& now, const ui::Requests&, bool quiet) override;
  bool busy() const override { return running_ != nullptr; }
  void forget() override;
  void fill(ui::Input& in) const override { in.stability = &shown_; }

 private:
  struct Run {
    SweepRunner runner;
    std::vector<std::vector<std::string>> stated;
    std::string failed;  // what went wrong while a point was measured
  };
  Run make_run(const Sweep&);
  void take(const ui::StabilityRequest&);
  void start();
  void stop();
  void work();
  void show();

  Lab& lab_;
  std::optional<StabilityBench> bench_;  // from the first sweep on
  std::map<std::string, Run> runs_;      // by the sweep's id
  Run* chosen_ = nullptr;                // is shown
  Run* running_ = nullptr;               // the chosen one or none
  std::string failed_;                   // why no sweep could be begun
  double begun_s_ = 0;
  size_t begun_at_ = 0;  // points
  ui::StabilityInput shown_;
};

}  // namespace gbl
