#pragma once
// What everything that is measured beside the window's picture has in common.
#include "app/bench.h"
#include "app/lab.h"

namespace gbl {

inline constexpr glm::ivec2 kBackgroundSize{320, 180};  // a row then takes about a second on a software driver

// All at one size, whatever is looked at.
Settings as_measured(Settings);

// Error(unfinished) where one frame would hold the window up for too long; `mend`: what to do instead. The reference's
// GPU part is a frame by the plainest method: that one counts, too.
void require_quick(const Settings&, Lab&, const char* where, const char* mend);

}  // namespace gbl
