#pragma once
// One view as a panel: its picture, a frame in the colour of the pass that wrote it, a badge and a legend on the
// picture. The window and the contact sheet draw the same panels.
#include <functional>
#include <string_view>

#include "renderer/inspect/views.h"
#include "ui/overlay_legends.h"
#include "ui/text.h"
#include "ui/ui.h"
#include "ui/zoom.h"

namespace gbl::ui {

struct PanelLook {
  float px = 13;          // badge and legend
  std::string_view name;  // replaces the view's label if not empty
  bool words = true;      // badge and legend; without: the picture and its frame
  bool chosen = false;
  Zoom zoom;
  float foot = 0;                       // at the lower edge, kept free of the legend
  std::vector<OverlayLegend> overlays;  // of what is laid over it
  std::function<void(Painter&)> over;   // drawn on the picture, below badge and legends
};

// The legend of a view as it is drawn now: the error's bar depends on what was found.
Legend legend_now(View, const Settings&, const Input&);

void draw_view_panel(Painter&, const Box&, View, const ViewImage&, const Settings&, const Legend&, const PanelLook&);

// Where the badge of a panel that shows its picture stands; px as in its look.
Box badge_box(const Box& panel, View, const Settings&, float px);

// Where the picture stands in its panel: all of it, unless their shapes differ.
Box picture_box(const Box& panel, glm::ivec2 picture);

void draw_legend(Painter&, const Box& panel, const Legend&, float px);

}  // namespace gbl::ui
