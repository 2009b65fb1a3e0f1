#pragma once
// Panels of the window in a captioned sheet, for ImGui frames drawn off screen: every figure is one.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/view_panel.h"

namespace gbl::ui {

// A part of the picture, enlarged in one of its corners, with a frame around where it is from.
struct SheetInset {
  Zoom zoom;
  bool right = true, top = true;
};

// Another picture of the same view, to the right of a line.
struct SheetAgainst {
  ViewImage image;
  double from = 0.5;        // 0..1 across the panel
  std::string left, right;  // at the foot, on each side of the line; may be empty
};

// All that a tile shows, as values: the pictures of one sheet may be of different settings.
struct SheetTile {
  View view;
  ViewImage image;
  Settings drawn;
  Legend legend;
  std::vector<OverlayLegend> overlays;
  std::string caption = {};  // below the picture; may be empty
  std::string name = {};     // replaces the view's label if not empty
  Zoom zoom = {};
  std::shared_ptr<const PixelNumbers> numbers = {};  // printed on the pixels
  std::optional<SheetInset> inset = {};
  std::optional<SheetAgainst> against = {};
};
// Of what the lab has just drawn. overlaid: what drawn.view.overlays names is laid over it.
SheetTile sheet_tile(View, const ViewImage&, const Settings& drawn, const Input&, bool overlaid);

struct Sheet {
  std::string title = {};    // first line; may be empty
  std::string caption = {};  // below the title; may be empty
  std::vector<SheetTile> tiles = {};
  int columns = 3;
  float tile_width = 480;  // pixels
  float scale = 1;         // of type, margins and lines
  bool light = false;      // on white paper
};
glm::ivec2 sheet_size(const Sheet&);  // pixels that draw_sheet needs; without an ImGui frame
void draw_sheet(const Sheet&);        // within one

}  // namespace gbl::ui
