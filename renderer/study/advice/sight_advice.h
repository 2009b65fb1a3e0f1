#pragma once
// How much a scene needs of what no layout stores: shadow maps, mirrors' pictures, steps into height maps. Of each axis alone,
// with nothing else lost, the cheapest value that holds the budget; where none does (a shadow's edge is never exact) the
// cheapest that is over by no more of the pixels than the best is and the budget allows.
#include <functional>
#include <string>
#include <vector>

#include "renderer/study/advice/advisor.h"
#include "renderer/study/advice/axis_values.h"

namespace gbl {

struct SightAxis {
  Patch alone;       // over the lossless set-up: what is true but for this
  Values values;     // cheapest first
  const char* what;  // "shadow maps", for sentences
};
// Those that this truth has; `lights`: how many could have shadows.
std::vector<SightAxis> sight_axes(const Settings& truth, int lights);

// judge: of a set-up, the worst of all cameras; empty: it is no answer. chosen: values that earlier axes took.
using WorstFn = std::function<std::optional<Tried>(const std::vector<Assignment>& values, const Settings&)>;
SightChoice choose_sight(const SightAxis&, const Settings& lossless, const std::vector<Assignment>& chosen,
                         const ErrorBudget&, const DeviceLimits&, const WorstFn& judge);

// A sentence for each value that was tried up to the one that is taken.
std::vector<std::string> in_sentences(const SightAxis&, const SightChoice&, const ErrorBudget&);

}  // namespace gbl
