#pragma once
// Measures a point of a stability curve: one frame against the reference, in targets of its own. No times.
#include <deque>

#include "app/truth_keeper.h"
#include "renderer/gl/device.h"
#include "renderer/study/stability.h"
#include "renderer/study/study_row.h"

namespace gbl {

class StabilityBench {
 public:
  explicit StabilityBench(FeatureSet without);  // needs a current context

  Measured measure(const SweepSetup&);
  DeviceLimits limits() const { return {device_.features, device_.max_size, device_.max_draw_buffers}; }
  DeviceRounding rounding() const { return rounding_; }
  Machine machine() const { return {device_.version, device_.renderer}; }

 private:
  const GpuScene& uploaded(const std::shared_ptr<const Scene>&);

  gl::Device device_;
  DeviceRounding rounding_;
  Renderer renderer_;
  Targets targets_;
  TruthKeeper truths_;
  std::unique_ptr<GpuScene> scene_;  // the last one
};

}  // namespace gbl
