#pragma once
// Colours and type of the window: one dark theme that holds on a projector. Text has a contrast of at least 7:1 on
// the surface it stands on; a colour never carries a meaning alone (a sign or a word goes with it).
#include <imgui.h>

#include "renderer/frame/attachments.h"

namespace gbl::ui {

inline constexpr ImU32 kBackground = IM_COL32(17, 19, 23, 255);
inline constexpr ImU32 kSurface = IM_COL32(27, 30, 36, 255);  // boxes, overlays
inline constexpr ImU32 kRaised = IM_COL32(46, 51, 60, 255);   // widgets, key caps
inline constexpr ImU32 kLine = IM_COL32(70, 77, 90, 255);     // rules and quiet frames
inline constexpr ImU32 kText = IM_COL32(238, 240, 244, 255);
inline constexpr ImU32 kDim = IM_COL32(184, 191, 202, 255);      // labels, units; not on kRaised
inline constexpr ImU32 kAccent = IM_COL32(255, 214, 102, 255);   // what is chosen, what to do next
inline constexpr ImU32 kUnsound = IM_COL32(255, 158, 164, 255);  // always beside the sign and the word
inline constexpr ImU32 kBacking = IM_COL32(12, 14, 18, 208);     // behind text on a picture
inline constexpr const char* kUnsoundSign = "⚠";

// Okabe and Ito 2008, Color Universal Design: sky blue, orange, bluish green (lightened), reddish purple (lightened).
ImU32 pass_colour(Pass);
const char* pass_name(Pass);   // "geometry pass (Fill)"
const char* pass_label(Pass);  // Fill, Light, Combine, Show

// Text sizes in pixels.
struct Type {
  float small, body, large;
};
Type type_for(float scale);  // 1 at 1600×900

void set_up_style();         // fonts at whole pixel sizes and the theme, into the current ImGui context
ImFont* font_for(float px);  // of the atlas: the smallest that is not smaller, else the largest

// Widgets inside the scope are drawn at this pixel size, in the current window.
class FontScope {
 public:
  explicit FontScope(float px);
  ~FontScope();
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;
};

}  // namespace gbl::ui
