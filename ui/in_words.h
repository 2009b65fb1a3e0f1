#pragma once
// What the window shows, as sentences: for captions, for the status line and for those who do not see it.
#include <string>

#include "renderer/inspect/pixel_probe.h"
#include "renderer/inspect/views.h"

namespace gbl::ui {

struct FrameContext;

std::string shown_in_words(const FrameContext&, View);               // the view, and how it is looked at
std::string pixel_in_words(const FrameContext&, const PixelProbe&);  // what is stored there, and what is shown
// All that a screen reader is given: the view, how it was made, the pixel that is pointed at or held, the lesson's step, the
// open panels, what a key has changed, what is wrong.
std::string in_words(const FrameContext&);

}  // namespace gbl::ui
