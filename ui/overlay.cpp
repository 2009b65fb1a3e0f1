// Windows above the pictures: fixed boxes without decoration; a line to type in, and the messages.
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

namespace {
// While a field has the keyboard ImGui keeps its text: it is changed in here only.
int put_text(ImGuiInputTextCallbackData* data) {
  auto& put = *static_cast<std::optional<std::string>*>(data->UserData);
  if (data->EventFlag != ImGuiInputTextFlags_CallbackAlways || !put) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, put->c_str());
  put.reset();
  return 0;
}
}  // namespace

bool draw_text_field(FrameContext& f, const char* id, const Box& box, float px, char* buffer, size_t size,
                     std::optional<std::string>* put) {
  const bool wanted = f.state.field == id;
  const FontScope font(px);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::round(px * 0.4f), std::floor((box.height() - px) / 2)});
  ImGui::SetCursorScreenPos(box.min);
  ImGui::SetNextItemWidth(box.width());
  if (wanted && f.state.focus_field) ImGui::SetKeyboardFocusHere();
  constexpr ImGuiInputTextFlags kPlain = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  constexpr ImGuiInputTextFlags kPut = ImGuiInputTextFlags_CallbackAlways |
                                       ImGuiInputTextFlags_CallbackCompletion;  // so that Tab does not leave the field
  bool entered = ImGui::InputText(fmt::format("##{}", id).c_str(), buffer, size, put ? kPlain | kPut : kPlain,
                                  put ? put_text : nullptr, put);
  // ImGui looks at keys once a frame: a tap shorter than a slow frame reaches us as an event only.
  entered |= ImGui::IsItemActive() && f.state.entered;
  if (entered) ImGui::SetWindowFocus(nullptr), f.state.entered = false;
  if (wanted && ImGui::IsItemActive()) f.state.focus_field = false;
  if (wanted && (entered || ImGui::IsItemDeactivated())) f.state.field.clear();
  ImGui::PopStyleVar();
  return entered;
}

// An error or a notice, across the top until the next key; errors alone while presenting. No window of ImGui's: one that appears would take the
// keyboard from whoever types.
void draw_notices(FrameContext& f) {
  State& s = f.state;
  if (f.input.message != s.dismissed) s.dismissed.clear();
  const std::string& text = s.notice.empty() ? f.input.message : s.notice;
  const Box& canvas = f.layout.canvas;
  const bool error = !s.notice.empty() || f.input.message_is_error;
  if (!text.empty() && text != s.dismissed && !s.hidden && (error || !s.present)) {
    const float pad = f.type.body * 0.6f, width = canvas.width() - 2 * pad;
    const float px = f.painter.fit(text, {width, f.type.body * 12}, f.type.body, true);
    const Box box{canvas.min, {canvas.max.x, canvas.min.y + text_size(text, px, width).y + 2 * pad}};
    Painter p(*ImGui::GetForegroundDrawList(), s.cut_texts);
    p.fill(box, theme().surface);
    p.outline(box, theme().line, 1);
    p.fill({box.min, {box.min.x + pad / 2, box.max.y}}, theme().accent);
    p.text({box.min.x + pad, box.min.y + pad}, px, theme().text, text, width);
  }
}

void draw_hidden_hint(FrameContext& f) {
  const Box& canvas = f.layout.canvas;
  const std::string_view hint = "F2 brings the panels back";
  const ImVec2 size = text_size(hint, f.type.small);
  const Box box{{canvas.max.x - size.x - 16, canvas.max.y - size.y - 10}, canvas.max};
  f.painter.fill(box, on_picture().backing);
  f.painter.text({box.min.x + 8, box.min.y + 5}, f.type.small, on_picture().dim, hint);
}

}  // namespace gbl::ui
