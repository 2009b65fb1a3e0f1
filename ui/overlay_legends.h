#pragma once
// What is laid over a picture, in words: name and strength, what its colours mean, and how much of the picture it marks.
#include <string>
#include <vector>

#include "ui/text.h"
#include "ui/ui.h"

namespace gbl::ui {

// "12.3 % of the pixels, at most 5", "lit 3.1 %, missed 0.2 %"; empty while nothing is known.
std::string marked_in_words(View, const ViewStats*);

struct OverlayLegend {
  std::string name, words;
  Legend legend;
};
// Of those that are drawn over this view, the topmost first.
std::vector<OverlayLegend> overlay_legends(View under, const Settings&, const Input&);

// Below the badge, one line each; returns where the next thing may stand.
float draw_overlay_legends(Painter&, const Box& panel, float top, const std::vector<OverlayLegend>&, float px);

}  // namespace gbl::ui
