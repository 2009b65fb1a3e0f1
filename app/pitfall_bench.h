#pragma once
// Draws one side of a pitfall and measures it against the truth that is meant, in targets of its own. No times.
#include <map>

#include "app/truth_keeper.h"
#include "renderer/gl/device.h"
#include "renderer/study/pitfalls/pitfall_metrics.h"
#include "renderer/study/rows/study_row.h"

namespace gbl {

class PitfallBench {
 public:
  // The device's current context; the renderer may draw for others, too.
  PitfallBench(Renderer&, const gl::Device&);

  PitfallEvidence measure(const Settings& drawn, const Settings& meant) { return *measured(drawn, meant, true); }
  // The same in slices: empty while the reference is being made.
  std::optional<PitfallEvidence> try_measure(const Settings& drawn, const Settings& meant) {
    return measured(drawn, meant, false);
  }
  void stop() { truths_.stop(); }  // gives the reference up that is being made
  DeviceLimits limits() const { return {device_.features, device_.max_size, device_.max_draw_buffers}; }
  DeviceRounding rounding() const { return rounding_; }
  Machine machine() const { return {device_.version, device_.renderer}; }

 private:
  std::optional<PitfallEvidence> measured(const Settings& drawn, const Settings& meant, bool wait);
  const GpuScene& scene(const std::string& name);

  gl::Device device_;
  DeviceRounding rounding_;
  Renderer& renderer_;
  Targets targets_;
  TruthKeeper truths_;
  std::map<std::string, std::unique_ptr<GpuScene>> scenes_;  // the catalogue's are few and small
};

}  // namespace gbl
