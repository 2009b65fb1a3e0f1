#pragma once
// Weights of work from measured times.
#include <span>

#include "renderer/frame/work_weights.h"

namespace gbl {

struct MeasuredWork {
  WorkCounts counts;
  double ms = 0;  // of the lighting pass; > 0
};

// The weights, none below WorkRow::at_least, under which the predicted times are nearest to the measured ones, relative to
// these. What no measurement tells stays in its proportion to the rest as llvmpipe has it.
WorkWeights fit_weights(std::span<const MeasuredWork>);

// How far predictions are off: the median of |predicted / measured - 1|.
double median_misfit(std::span<const MeasuredWork>, const WorkWeights&);

}  // namespace gbl
