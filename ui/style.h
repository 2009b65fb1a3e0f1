#pragma once
// Type of the window, the words for passes, and the widgets' style.
#include <imgui.h>

#include "renderer/frame/attachments.h"
#include "ui/theme.h"

namespace gbl::ui {

inline constexpr const char* kUnsoundSign = "⚠";

ImU32 pass_colour(Pass, const Theme& = theme());
const char* pass_name(Pass);   // "geometry pass (Fill)"
const char* pass_label(Pass);  // Fill, Light, Combine, Show

// Text sizes in pixels.
struct Type {
  float small, body, large;
};
Type type_for(float scale);  // 1 at 1600×900

void set_up_style();         // fonts at whole pixel sizes and the dark theme, into the current ImGui context
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
