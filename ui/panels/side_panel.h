#pragma once
// What the panels on the right half have in common: their place, a line with a key in it, and their keys at the end.
#include <span>

#include "ui/state.h"

namespace gbl::ui {

// Takes lines off a panel's room, from its top and from its bottom; what is left is `room`.
struct Shelf {
  Box room;
  float gap;
  Box below(float height) {
    const Box box{room.min, {room.max.x, room.min.y + height}};
    room.min.y = box.max.y + gap;
    return box;
  }
  Box above(float height) {
    const Box box{{room.min.x, room.max.y - height}, room.max};
    room.max.y = box.min.y - gap;
    return box;
  }
};

Box side_box(const FrameContext&);  // the right half
Box edge_box(const FrameContext&);  // along the right edge; large type takes more of it
void draw_keyed(Painter&, const Box&, float px, std::string_view key, ImU32 colour, std::string_view words);
// The keys with their words, line after line, as large as they fit; a single key is a button as well.
void draw_panel_keys(FrameContext&, Painter&, const Box&, std::span<const PanelKey>);

}  // namespace gbl::ui
