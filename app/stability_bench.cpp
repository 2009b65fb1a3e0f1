#include "app/stability_bench.h"

#include "renderer/base/threads.h"

namespace gbl {
namespace {

// A point's curves differ in their method, and few in their truth.
constexpr size_t kTruthsOfAPoint = 4;

// Neither known way of rounding is taken for the coarser of the two.
StoreRounding rounding_of(gl::Rounding r) {
  return r == gl::Rounding::to_nearest ? StoreRounding::to_nearest : StoreRounding::toward_zero;
}

}  // namespace

DeviceRounding device_rounding() {
  const gl::RoundingProbe probe = gl::probe_rounding();
  return {rounding_of(probe.half_store), rounding_of(probe.half_blend), rounding_of(probe.r11_store)};
}

StabilityBench::StabilityBench(Renderer& renderer, const gl::Device& device)
    : device_(device), rounding_(device_rounding()), renderer_(renderer), truths_(kTruthsOfAPoint, all_processors()) {}

const GpuScene& StabilityBench::uploaded(const std::shared_ptr<const Scene>& scene) {
  if (!scene_ || scene_->shared_scene() != scene) scene_ = std::make_unique<GpuScene>(scene);
  return *scene_;
}

std::optional<Measured> StabilityBench::measure(const SweepSetup& setup, bool wait) {
  const Settings& s = setup.settings;
  require_valid(s, limits());
  const GpuScene& scene = uploaded(setup.scene);
  const std::shared_ptr<const TruthSet> truth = truths_.get(renderer_, scene, s, wait);
  if (!truth) return {};
  FrameReport report = renderer_.render(s, scene, targets_);
  Drawn drawn = read_drawn(renderer_, s, scene, targets_, true);
  renderer_.collect(targets_, report, true);
  const Errors errors = gbl::measure(truth->truth, drawn, {s.exposure, s.colour});
  return Measured{errors, {truth, &truth->truth}, std::move(drawn)};
}

Measured StabilityBench::measure(const SweepSetup& setup) { return *measure(setup, true); }
std::optional<Measured> StabilityBench::try_measure(const SweepSetup& setup) { return measure(setup, false); }

}  // namespace gbl
