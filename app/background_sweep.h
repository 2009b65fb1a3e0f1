#pragma once
// Stability sweeps while the window goes on: a point a frame, with targets of its own, and only while nothing else
// wants the machine. Sweeps bring scenes and cameras of their own: what the window shows does not matter to them.
#include <map>

#include "app/stability_bench.h"
#include "ui/ui.h"

namespace gbl {

class Lab;

class BackgroundSweep {
 public:
  explicit BackgroundSweep(Lab& lab) : lab_(lab) {}

  // Once a frame. `quiet`: nobody touches the window and nothing moves in it; only then is anything measured.
  void update(const ui::Requests::Stability&, bool quiet);
  bool busy() const { return running_ != nullptr; }
  void forget();  // other programs draw: what was measured says nothing about them
  const ui::StabilityInput& input() const { return shown_; }

 private:
  struct Run {
    SweepRunner runner;
    std::vector<std::vector<std::string>> stated;
    std::string failed;  // what went wrong while a point was measured
  };
  Run make_run(const Sweep&);
  void take(const ui::Requests::Stability&);
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
