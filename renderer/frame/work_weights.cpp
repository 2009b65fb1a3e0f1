#include "renderer/frame/work_weights.h"

namespace gbl {
namespace {

WorkWeights& in_use() {
  static WorkWeights weights = llvmpipe_weights();
  return weights;
}

}  // namespace

WorkWeights llvmpipe_weights() {
  WorkWeights w;
  for (const WorkRow& r : kWork) w.units[r.work] = r.llvmpipe;
  return w;
}

double units_of(const WorkCounts& counts, const WorkWeights& weights) {
  double sum = 0;
  for (const WorkRow& r : kWork) sum += counts[r.work] * weights.units[r.work];
  return sum;
}

const WorkWeights& work_weights() { return in_use(); }
void use_work_weights(const WorkWeights& w) { in_use() = w; }

}  // namespace gbl
