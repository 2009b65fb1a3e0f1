#pragma once
// Where everything stands. The first screen is a table of rectangles at 1600×900; other windows scale it, pictures
// stay 16:9, and height that is left over goes to the strip and the control column.
#include <array>
#include <optional>
#include <vector>

#include "renderer/inspect/views.h"
#include "ui/text.h"

namespace gbl::ui {

struct LayoutInput {
  ImVec2 display;
  View chosen = View::final;
  bool large = false;        // the chosen view alone
  std::vector<LookOf> page;  // of the mosaic, the first one large; empty: the usual first page
  bool hidden = false;       // pictures only
  bool present = false;      // the large picture fills the window, and the strip goes from edge to edge
  bool beside = false;       // a panel stands on the right half: the large picture stays in the left one
  float status_height = 25;
};

// A panel that keeps a look of its own: a second one of a view that is shown elsewhere, too.
struct LockedPanel {
  LookOf look;
  size_t place;  // in the mosaic
  Box box;
};

struct Layout {
  float unit = 1;                                     // screen pixels per pixel of the 1600×900 design
  std::array<std::optional<Box>, kViewCount> panels;  // by View; empty = not on screen
  std::vector<LockedPanel> locked;
  View main = View::final;
  Box canvas, strip, column, status;
  float foot = 0;  // of the large picture, below its badge and legends: a caption lies on it
  const Box& main_box() const { return *panels[static_cast<size_t>(main)]; }
};

Layout make_layout(const LayoutInput&);
std::vector<LookOf> usual_panels();  // of the first page, by place

}  // namespace gbl::ui
