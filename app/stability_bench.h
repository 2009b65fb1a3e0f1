#pragma once
// Measures a point of a stability curve: one frame against the reference, in targets of its own. No times.
#include <deque>

#include "app/truth_keeper.h"
#include "renderer/gl/device.h"
#include "renderer/study/rows/study_row.h"
#include "renderer/study/stability/stability.h"

namespace gbl {

DeviceRounding device_rounding();  // of the current context

class StabilityBench {
 public:
  // The device's current context; the renderer may draw for others, too.
  StabilityBench(Renderer&, const gl::Device&);

  Measured measure(const SweepSetup&);
  // The same in slices: empty while the reference is being made.
  std::optional<Measured> try_measure(const SweepSetup&);
  void stop() { truths_.stop(); }  // gives the reference up that is being made
  DeviceLimits limits() const { return {device_.features, device_.max_size, device_.max_draw_buffers}; }
  DeviceRounding rounding() const { return rounding_; }
  Machine machine() const { return {device_.version, device_.renderer}; }

 private:
  std::optional<Measured> measure(const SweepSetup&, bool wait);
  const GpuScene& uploaded(const std::shared_ptr<const Scene>&);

  gl::Device device_;
  DeviceRounding rounding_;
  Renderer& renderer_;
  Targets targets_;
  TruthKeeper truths_;
  std::unique_ptr<GpuScene> scene_;  // the last one
};

}  // namespace gbl
