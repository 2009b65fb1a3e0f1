#pragma once
// Views that need the reference, drawn by a command: it waits, and on a terminal it says how far the reference is.
#include "app/lab.h"

namespace gbl {

void draw_against_truth(Lab&, View);

// Whatever the view needs. overlays: what the settings lay over it
void draw_any_view(Lab&, View, bool overlays);

}  // namespace gbl
