#pragma once
// The histogram of the large picture: how often each number is seen, with handles and fields for black and white.
#include "ui/text.h"

namespace gbl::ui {

struct FrameContext;

struct HistogramBoxes {
  Box all, plot;            // bars; the handles hang below them
  Box names[2], fields[2];  // of black and white
  Box counts;               // a button: how bars count
};
HistogramBoxes histogram_boxes(const Box& panel, float px);

void use_histogram(FrameContext&);   // its handles, before what lies below it
void draw_histogram(FrameContext&);  // and its fields

}  // namespace gbl::ui
