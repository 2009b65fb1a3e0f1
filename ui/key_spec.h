#pragma once
// Keys as all tables write them: "C", "[ ]", "Left Right", "Ctrl+G", "Shift , .", "1-8"; and the one matcher of such a
// text with a key that was pressed.
#include <string>
#include <string_view>
#include <vector>

#include "ui/ui.h"

namespace gbl::ui {

struct KeySpec {
  bool shift = false, ctrl = false;
  std::vector<std::string> keys;  // "1-8" is eight of them
};
KeySpec key_spec(std::string_view text);

// Which of its keys this is, from 0; empty: none. Shift is free unless the text names it, Ctrl is not.
std::optional<size_t> which_key(const KeySpec&, const KeyEvent&);

// The event as a table's function gets it: its key is the table's ("+", not "=").
KeyEvent as_in_table(const KeySpec&, size_t which, const KeyEvent&);

// As they are printed on caps: "Left 1-8" -> "←", "1-8".
std::vector<std::string> key_caps(std::string_view text);
std::string printed_keys(std::string_view text);  // in one

}  // namespace gbl::ui
