#include "app/view_meter.h"

#include <cstring>

namespace gbl {
namespace {

size_t at(View v) { return static_cast<size_t>(v); }

}  // namespace

void ViewMeter::ask(View v, Renderer& renderer, const Settings& s, const GpuScene& scene, Targets& targets,
                    const ViewOptions& options) {
  renderer.draw_numbers(v, s, scene, targets, sample_grid(s.size), options);
  asked_[at(v)].start(targets.canvases.numbers().texture);
}

bool ViewMeter::take(View v, bool wait) {
  const std::vector<float>* floats = asked_[at(v)].take(wait);
  if (!floats) return false;
  std::vector<glm::vec4> numbers(floats->size() / 4);
  std::memcpy(numbers.data(), floats->data(), floats->size() * sizeof(float));
  known_[at(v)] = view_stats(numbers, row(v).values.components);
  return true;
}

const ViewStats* ViewMeter::of(View v) const { return known_[at(v)] ? &*known_[at(v)] : nullptr; }

void ViewMeter::forget() {
  for (auto& a : asked_) a.drop();
  known_.fill({});
}

}  // namespace gbl
