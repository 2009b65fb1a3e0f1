#pragma once
// The window without a window.
#include "app/lab.h"

namespace gbl {

// The first screen as a window of this size shows it. Without times the same picture comes out each time.
Image first_screen(Lab&, Settings, glm::ivec2 window, bool times);

}  // namespace gbl
