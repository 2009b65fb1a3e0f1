#include "app/pitfall_bench.h"

#include "app/stability_bench.h"
#include "renderer/base/threads.h"
#include "renderer/opening/scene_look.h"

namespace gbl {
namespace {

constexpr size_t kTruthsKept = 4;  // broken and fixed mostly share one

}  // namespace

PitfallBench::PitfallBench(Renderer& renderer, const gl::Device& device)
    : device_(device), rounding_(device_rounding()), renderer_(renderer), truths_(kTruthsKept, all_processors()) {}

const GpuScene& PitfallBench::scene(const std::string& name) {
  std::unique_ptr<GpuScene>& kept = scenes_[name];
  if (!kept) kept = std::make_unique<GpuScene>(open_scene(name));
  return *kept;
}

std::optional<PitfallEvidence> PitfallBench::measured(const Settings& drawn, const Settings& meant, bool wait) {
  const GpuScene& in = scene(drawn.scene);
  const std::shared_ptr<const TruthSet> truth = truths_.get(renderer_, in, meant, wait);
  if (!truth) return {};
  FrameReport report = renderer_.render(drawn, in, targets_);
  PitfallEvidence out{.setup = {drawn, in.shared_scene()}, .meant = meant};
  renderer_.count_pairs(drawn, in, targets_, true);
  renderer_.collect(targets_, report, true);
  out.pairs = report.pairs;
  out.report = report;
  Drawn read = read_drawn(renderer_, drawn, in, targets_, true);
  const Display display{drawn.exposure, drawn.colour};
  for (const glm::vec3& radiance : read.shown) out.shown.emplace_back(displayed(display, radiance));
  const Errors errors = gbl::measure(truth->truth, read, display);
  out.measured = {errors, {truth, &truth->truth}, std::move(read)};
  return out;
}

}  // namespace gbl
