#pragma once
// What the panels on the right half have in common: their place, their keys, a line with a key in it.
#include <span>

#include "ui/state.h"

namespace gbl::ui {

struct PanelKey {
  const char* key;    // as printed
  const char* words;  // for the hint line
  void (*run)(FrameContext&, const KeyEvent&);
  const char* events = nullptr;  // names of its key events, with spaces between; null: the letter that is printed
  bool repeats = false;
};

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

Box side_box(const FrameContext&);
void draw_keyed(Painter&, const Box&, float px, std::string_view key, ImU32 colour, std::string_view words);
// The keys with their words, line after line, as large as they fit; a single key is a button as well.
void draw_panel_keys(FrameContext&, Painter&, const Box&, std::span<const PanelKey>);
// True: the key was one of them.
bool press_in_panel(FrameContext&, const KeyEvent&, std::span<const PanelKey>);

// One is open at a time: the wanted one opens or closes.
void toggle_side(State&, bool& open);

}  // namespace gbl::ui
