#pragma once
// The keyboard as one table: an option's key stands in its row of the options table, a view's in its row of the
// views table, a panel's in its row of the panels table, everything else is a command here. F1, `list keys` and the dispatch read the same rows.
#include <string_view>
#include <vector>

#include "ui/ui.h"

namespace gbl::ui {

struct FrameContext;

struct KeyCommand {
  const char* key;  // as printed: "Home", ", .", "Shift , .", "Ctrl+G"
  const char* id;
  const char* help;
  void (*run)(FrameContext&, const KeyEvent&);  // null: acts while held
  bool repeats = false;                         // also when the keyboard repeats the key
};

void dispatch(FrameContext&, const KeyEvent&);
// A field that is being typed into, or will be in the next frame, keeps every key but Esc.
bool typing(const FrameContext&);

// Presses that a row answers to, e.g. "[ ]" -> "[" and "]"; what scripts and tests send.
std::vector<KeyEvent> presses_of(const KeyRow&);

}  // namespace gbl::ui
