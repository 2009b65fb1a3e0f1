// Windows above the pictures: fixed boxes without decoration; the pixel's dialog and the messages.
#include <fmt/format.h>

#include "ui/state.h"

namespace gbl::ui {

bool begin_overlay(const char* id, const Box& box, ImU32 background) {
  ImGui::SetNextWindowPos(box.min);
  ImGui::SetNextWindowSize(box.size());
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoSavedSettings;
  return ImGui::Begin(id, nullptr, kFixed);
}

void end_overlay() {
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

// Ctrl+G: two numbers; Enter holds the pixel there, Esc leaves.
void draw_go_to(Frame& f) {
  State& s = f.state;
  if (!s.go_to) return;
  const float px = f.type.body, line = line_height(px), width = px * 20;
  const Box& main = f.layout.main_box();
  const ImVec2 min{std::floor(main.min.x + (main.width() - width) / 2), std::floor(main.min.y + main.height() * 0.4f)};
  const Box box{min, {min.x + width, min.y + 4.5f * line}};
  begin_overlay("go to pixel", box, kSurface);
  Painter p(*ImGui::GetWindowDrawList(), s.cut_texts);
  const glm::ivec2 size = f.frame_size();
  const Box room = box.inset(px * 0.6f);
  p.text_in({room.min, {room.max.x, room.min.y + line}}, px, kText, "Hold the pixel at x, y");
  {
    const FontScope font(px);
    ImGui::SetCursorScreenPos({room.min.x, room.min.y + line * 1.2f});
    ImGui::SetNextItemWidth(room.width());
    if (s.focus_go_to) ImGui::SetKeyboardFocusHere();
    s.focus_go_to = false;
    if (ImGui::InputInt2("##pixel", &s.go_to_pixel.x, ImGuiInputTextFlags_EnterReturnsTrue)) {
      s.held_pixel = glm::clamp(s.go_to_pixel, glm::ivec2(0), size - 1);
      s.go_to = false;
    }
  }
  p.text_in({{room.min.x, room.max.y - line}, room.max}, f.type.small, kDim,
            fmt::format("0 … {}, 0 … {} from the top left; Tab, Enter", size.x - 1, size.y - 1));
  end_overlay();
}

// An error or a notice, across the top until the next key.
void draw_notices(Frame& f) {
  State& s = f.state;
  if (f.input.message != s.dismissed) s.dismissed.clear();
  const std::string& text = s.notice.empty() ? f.input.message : s.notice;
  const Box& canvas = f.layout.canvas;
  if (!text.empty() && text != s.dismissed && !s.hidden) {
    const float pad = f.type.body * 0.6f, width = canvas.width() - 2 * pad;
    const float px = f.painter.fit(text, {width, f.type.body * 12}, f.type.body, true);
    const Box box{canvas.min, {canvas.max.x, canvas.min.y + text_size(text, px, width).y + 2 * pad}};
    begin_overlay("message", box, kSurface);
    Painter p(*ImGui::GetWindowDrawList(), s.cut_texts);
    p.fill({box.min, {box.min.x + pad / 2, box.max.y}}, kAccent);
    p.text({box.min.x + pad, box.min.y + pad}, px, kText, text, width);
    end_overlay();
  }
}

void draw_hidden_hint(Frame& f) {
  const Box& canvas = f.layout.canvas;
  const std::string_view hint = "F2 brings the panels back";
  const ImVec2 size = text_size(hint, f.type.small);
  const Box box{{canvas.max.x - size.x - 16, canvas.max.y - size.y - 10}, canvas.max};
  f.painter.fill(box, kBacking);
  f.painter.text({box.min.x + 8, box.min.y + 5}, f.type.small, kDim, hint);
}

}  // namespace gbl::ui
