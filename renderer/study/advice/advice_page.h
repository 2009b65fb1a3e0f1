#pragma once
// advice.html: the set-ups that were tried as a page, with the chosen one marked.
#include "renderer/study/advice/advisor.h"
#include "renderer/study/page/page.h"
#include "renderer/study/rows/study_row.h"

namespace gbl {

struct AdviceAsked {
  Settings truth;
  ErrorBudget budget;
  AdviceCost cost = AdviceCost::time;
  FeatureSet features;
};
// command: the line that measures these settings again.
Page advice_page(const Advice&, const AdviceAsked&, const Machine&,
                 const std::function<std::string(const Settings&)>& command);

}  // namespace gbl
