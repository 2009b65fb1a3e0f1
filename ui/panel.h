#pragma once
// Panels: what opens and closes over the pictures. To add one: its file, with one row of this kind in it, and its name
// in the table of panels.cpp. Its key, F1's list, Esc, the order of keys, the room it takes: all follow from the row.
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/text.h"
#include "ui/ui.h"

namespace gbl::ui {

struct FrameContext;
struct State;

// A key of an open panel.
struct PanelKey {
  const char* key;                              // as all tables write keys
  const char* words;                            // for the panel's last lines and for F1
  void (*run)(FrameContext&, const KeyEvent&);  // null: another table's row answers, this one is printed only
  bool repeats = false;                         // also when the keyboard repeats the key
};

enum class Place {
  over,    // above some of the pictures
  whole,   // above all of them
  edge,    // along the right edge: the strip ends there, and letters are the panel's
  beside,  // as `edge`, on the right half: the large picture moves into the left one, and one such panel is open
};

// What a panel remembers between frames; its file adds what it needs.
struct PanelState {
  bool open = false;
  virtual ~PanelState() = default;
};
template <class T>
std::unique_ptr<PanelState> make_panel_state() {
  return std::make_unique<T>();
}

struct Panel {
  const char* key;  // opens and closes it; this and the next two are its row in the table of all keys
  const char* id;
  const char* help;
  Place place;
  Box (*box)(const FrameContext&);                    // where it stands; empty: it is open, but not on screen now
  void (*draw)(FrameContext&, Painter&, const Box&);  // while it is on screen
  std::span<const PanelKey> keys = {};                // while it is open
  std::unique_ptr<PanelState> (*make)() = make_panel_state<PanelState>;
  void (*press)(FrameContext&, const KeyEvent&) = nullptr;        // its key does more than to open and close it
  bool (*press_other)(FrameContext&, const KeyEvent&) = nullptr;  // keys that stand in no table; true: it was one
  void (*update)(FrameContext&) = nullptr;  // once a frame, open or not; what it asks of the app is said here
  void (*follow)(State&, View) = nullptr;   // a view is shown by its key
  std::string (*in_words)(const FrameContext&) = nullptr;  // what it says now, for those who do not see it
};

std::span<const Panel* const> panels();  // from the topmost to the lowest
std::vector<std::unique_ptr<PanelState>> make_panel_states();
const Panel& panel(std::string_view id);
bool is_open(const State&, std::string_view id);
bool panel_beside(const State&);
bool letters_are_a_panels(const State&);  // and not the camera's

void press_panel(FrameContext&, const Panel&, const KeyEvent&);  // its key
bool press_in_panels(FrameContext&, const KeyEvent&);            // a key of an open one; true: it was one
bool close_top_panel(State&);                                    // true: there was one
void close_panels(State&, std::initializer_list<Place>);         // those that stand there
void turn_panels(State&, View);                                  // a view is shown: those that tell of one follow

void draw_panels(FrameContext&);
std::string panels_in_words(const FrameContext&);  // a line for each that is open
bool covered(const FrameContext&, const Box&);     // wholly below one
void make_room(FrameContext&);                     // in the layout, for those that are open

}  // namespace gbl::ui
