// Windows above the pictures: fixed boxes without decoration; the pixel's dialog and the messages.
#include <fmt/format.h>

#include "renderer/base/size_text.h"
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

bool draw_text_field(FrameContext& f, const char* id, const Box& box, float px, char* buffer, size_t size, bool focus) {
  const FontScope font(px);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::round(px * 0.4f), std::floor((box.height() - px) / 2)});
  ImGui::SetCursorScreenPos(box.min);
  ImGui::SetNextItemWidth(box.width());
  if (focus) ImGui::SetKeyboardFocusHere();
  bool entered = ImGui::InputText(fmt::format("##{}", id).c_str(), buffer, size,
                                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  // ImGui looks at keys once a frame: a tap shorter than a slow frame reaches us as an event only.
  entered |= ImGui::IsItemActive() && f.state.entered;
  if (entered) ImGui::SetWindowFocus(nullptr);
  ImGui::PopStyleVar();
  return entered;
}

// Ctrl+G: two numbers; Enter holds the pixel there, Esc leaves.
void draw_go_to(FrameContext& f) {
  State& s = f.state;
  if (!s.go_to) return;
  const float px = f.type.body, line = line_height(px), width = px * 20;
  const Box& main = f.layout.main_box();
  const ImVec2 min{std::floor(main.min.x + (main.width() - width) / 2), std::floor(main.min.y + main.height() * 0.4f)};
  const Box box{min, {min.x + width, min.y + std::round(5 * line)}};
  begin_overlay("go to pixel", box, kSurface);
  Painter p(*ImGui::GetWindowDrawList(), s.cut_texts);
  const Box room = box.inset(std::round(px * 0.6f));
  p.text_in({room.min, {room.max.x, room.min.y + line}}, px, kText, "Hold the pixel at x, y");
  const float top = room.min.y + std::round(1.3f * line);
  const Box field{{room.min.x, top}, {room.max.x, top + std::round(1.6f * line)}};
  const bool entered = draw_text_field(f, "pixel", field, px, s.go_to_text.data(), s.go_to_text.size(), s.focus_go_to);
  if (ImGui::IsItemActive()) s.focus_go_to = false;
  const glm::ivec2 last = f.frame_size() - 1;
  if (entered) {
    s.go_to = false;
    if (const std::optional<glm::ivec2> pixel = pixel_of(s.go_to_text.data()))
      f.hold(*pixel);
    else
      s.notice = fmt::format("'{}' is not a pixel; write two whole numbers, x, y", s.go_to_text.data());
  }
  p.text_in({{room.min.x, room.max.y - line_height(f.type.small)}, room.max}, f.type.small, kDim,
            fmt::format("0 … {}, 0 … {} from the top left; Enter", last.x, last.y));
  end_overlay();
}

// An error or a notice, across the top until the next key.
void draw_notices(FrameContext& f) {
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

void draw_hidden_hint(FrameContext& f) {
  const Box& canvas = f.layout.canvas;
  const std::string_view hint = "F2 brings the panels back";
  const ImVec2 size = text_size(hint, f.type.small);
  const Box box{{canvas.max.x - size.x - 16, canvas.max.y - size.y - 10}, canvas.max};
  f.painter.fill(box, kBacking);
  f.painter.text({box.min.x + 8, box.min.y + 5}, f.type.small, kDim, hint);
}

}  // namespace gbl::ui
