#pragma once
// The colours of the window: a dark theme and a light one, both for a projector. A test holds that every text has a
// contrast of at least 7:1 on the surfaces it stands on. A colour never carries a meaning alone: a sign or a word goes
// with it.
#include <array>
#include <imgui.h>

#include "renderer/frame/attachments.h"

namespace gbl::ui {

struct Theme {
  const char* name;
  ImU32 background;
  ImU32 surface;                   // boxes, overlays
  ImU32 raised, hovered, pressed;  // widgets, key caps
  ImU32 line;                      // rules and quiet frames
  ImU32 backing;                   // behind text on a picture or a plot
  ImU32 wrong;                     // a bar that counts what is wrong; text stands on it
  ImU32 selection;                 // in a line to type in
  ImU32 text;
  ImU32 dim;                    // labels, units
  ImU32 accent;                 // what is chosen, what to do next
  ImU32 unsound;                // always beside the sign and the word
  ImU32 edge;                   // around marks: they stay apart where they overlap
  std::array<ImU32, 4> passes;  // by Pass
  std::array<ImU32, 7> series;  // of plots: seven, for the eight marks: no common factor
};

extern const Theme kDarkTheme, kLightTheme;

const Theme& theme();          // of this frame
void use_theme(const Theme&);  // from here on, and in the current ImGui context

// Badges, legends and words that lie on a picture: it does not change with the window.
inline const Theme& on_picture() { return kDarkTheme; }

}  // namespace gbl::ui
