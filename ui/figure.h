#pragma once
// F12: a panel as it is shown, with a caption that says how it was made; and what is put on the clipboard as text.
#include <string>
#include <vector>

#include "ui/text.h"
#include "ui/ui.h"

namespace gbl::ui {

struct FrameContext;

// "Start · 64 lights, light volumes · cull flip · normal octahedral 16+16 · 12 + 16 B/px".
std::string made_in_words(const Settings&, const FrameReport&);

void save_panel(FrameContext&, const KeyEvent&);   // F12
void save_window(FrameContext&, const KeyEvent&);  // Shift+F12
void copy_values(FrameContext&, const KeyEvent&);  // of the held pixel
void copy_command(FrameContext&, const KeyEvent&);

}  // namespace gbl::ui
