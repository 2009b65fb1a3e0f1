#pragma once
// What a talk needs on the pictures: a ring that points, and the time with the lesson's steps.
#include "ui/state.h"

namespace gbl::ui {

void draw_talk_timer(FrameContext&);
void draw_reticle(FrameContext&);  // above everything else

}  // namespace gbl::ui
