#pragma once
// Presenting: the picture, and at its foot one caption in large type: the lesson's, or the view's key and sentence.
#include "ui/state.h"

namespace gbl::ui {

float presenting_foot(const FrameContext&);  // how much of the large picture the caption lies on, in pixels
void draw_presenting(FrameContext&);

}  // namespace gbl::ui
