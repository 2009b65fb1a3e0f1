#pragma once
// How much a scene needs of what no layout stores: shadow maps, mirrors' pictures, steps into height maps. Each axis is judged
// alone, with nothing else lost: the cheapest value that holds the budget is taken. A shadow's edge is never exact: where no value
// holds, it is the cheapest whose share of pixels over the bound is above the best one's by no more than the budget's share.
#include <functional>
#include <string>
#include <vector>

#include "renderer/study/advice/advisor.h"

namespace gbl {

struct SightAdvice {
  std::vector<SightChoice> choices;   // of each axis that this truth has
  std::vector<Assignment> chosen;     // the values that are taken
  std::vector<std::string> left_out;  // a sentence for each value that was tried and not taken, or does not hold
};

// Of a set-up, the worst of all cameras.
using WorstFn = std::function<Tried(const std::vector<Assignment>& values, const Settings&)>;

// lossless: loses nothing of what is stored, and nothing in it is hidden, mirrored or sunk.
SightAdvice advise_sights(const Settings& truth, const Settings& lossless, const Scene&, const ErrorBudget&,
                          const DeviceLimits&, const WorstFn&);

}  // namespace gbl
