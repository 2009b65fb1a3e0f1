#pragma once
// What the advisor asks of a device: is the bound held from a camera, and what does a set-up cost.
#include "app/bench.h"
#include "renderer/study/advice/advisor.h"

namespace gbl {

class Lab;

class AdviceBench {
 public:
  AdviceBench(Lab&, const ErrorBudget&, AdviceCost);  // of the scene that the lab shows now

  // Begin one measurement; Error where the device cannot draw the set-up.
  void start_bound(Settings, int camera);
  void start_cost(Settings);
  bool step(bool wait) { return bench_.step(wait); }  // true: it is complete
  void stop() { bench_.stop(); }
  BoundCheck bound() const { return bench_.bound(budget_.display_difference); }
  double cost() const;

 private:
  void start(const Settings&, BenchWishes);
  const Camera& camera(const Camera& own, int k);

  Lab& lab_;
  std::shared_ptr<const GpuScene> scene_;
  ErrorBudget budget_;
  AdviceCost cost_;
  Bench bench_;
  Camera own_;                   // that the others belong to
  std::vector<Camera> cameras_;  // as far as they were wanted
};

}  // namespace gbl
