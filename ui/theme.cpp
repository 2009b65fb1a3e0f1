#include "ui/theme.h"

namespace gbl::ui {
namespace {

const Theme* current = &kDarkTheme;

ImVec4 colour(ImU32 c) { return ImGui::ColorConvertU32ToFloat4(c); }

}  // namespace

// Passes and series: Okabe and Ito 2008, "Color Universal Design". Green, purple and vermilion are lightened for the
// dark ground, white stands for their black, and their blue, too dark here, is left out.
const Theme kDarkTheme = {
    .name = "dark",
    .background = IM_COL32(17, 19, 23, 255),
    .surface = IM_COL32(27, 30, 36, 255),
    .raised = IM_COL32(40, 45, 53, 255),
    .hovered = IM_COL32(46, 51, 60, 255),
    .pressed = IM_COL32(30, 33, 40, 255),
    .line = IM_COL32(70, 77, 90, 255),
    .backing = IM_COL32(12, 14, 18, 228),
    .wrong = IM_COL32(122, 56, 62, 255),
    .selection = IM_COL32(84, 75, 45, 255),
    .text = IM_COL32(238, 240, 244, 255),
    .dim = IM_COL32(190, 197, 208, 255),
    .accent = IM_COL32(255, 214, 102, 255),
    .unsound = IM_COL32(255, 176, 180, 255),
    .edge = IM_COL32(10, 12, 15, 255),
    .passes = {IM_COL32(86, 180, 233, 255), IM_COL32(240, 159, 40, 255), IM_COL32(52, 200, 160, 255),
               IM_COL32(222, 150, 196, 255)},
    .series = {IM_COL32(86, 180, 233, 255), IM_COL32(240, 159, 40, 255), IM_COL32(52, 200, 160, 255),
               IM_COL32(222, 150, 196, 255), IM_COL32(240, 228, 66, 255), IM_COL32(240, 110, 60, 255),
               IM_COL32(238, 240, 244, 255)},
};

// The same hues, darkened until they hold on white; their yellow becomes olive.
const Theme kLightTheme = {
    .name = "light",
    .background = IM_COL32(250, 250, 251, 255),
    .surface = IM_COL32(238, 240, 243, 255),
    .raised = IM_COL32(224, 228, 234, 255),
    .hovered = IM_COL32(214, 219, 227, 255),
    .pressed = IM_COL32(240, 243, 247, 255),
    .line = IM_COL32(150, 157, 168, 255),
    .backing = IM_COL32(255, 255, 255, 232),
    .wrong = IM_COL32(240, 186, 190, 255),
    .selection = IM_COL32(190, 208, 250, 255),
    .text = IM_COL32(20, 23, 28, 255),
    .dim = IM_COL32(66, 72, 82, 255),
    .accent = IM_COL32(16, 48, 150, 255),
    .unsound = IM_COL32(134, 0, 26, 255),
    .edge = IM_COL32(255, 255, 255, 255),
    .passes = {IM_COL32(0, 82, 118, 255), IM_COL32(128, 58, 0, 255), IM_COL32(0, 90, 64, 255),
               IM_COL32(126, 40, 104, 255)},
    .series = {IM_COL32(0, 114, 178, 255), IM_COL32(190, 95, 0, 255), IM_COL32(0, 125, 92, 255),
               IM_COL32(170, 70, 130, 255), IM_COL32(130, 118, 0, 255), IM_COL32(200, 60, 20, 255),
               IM_COL32(20, 23, 28, 255)},
};

const Theme& theme() { return *current; }

void use_theme(const Theme& t) {
  current = &t;
  ImGuiStyle& style = ImGui::GetStyle();
  ImGui::StyleColorsDark(&style);
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = colour(t.text);
  c[ImGuiCol_TextDisabled] = colour(t.dim);
  c[ImGuiCol_WindowBg] = colour(t.background);
  c[ImGuiCol_PopupBg] = c[ImGuiCol_ScrollbarBg] = colour(t.surface);
  c[ImGuiCol_Border] = c[ImGuiCol_ScrollbarGrab] = colour(t.line);
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = c[ImGuiCol_Header] = colour(t.raised);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = colour(t.hovered);
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = colour(t.pressed);
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = c[ImGuiCol_CheckMark] = colour(t.accent);
  c[ImGuiCol_NavHighlight] = c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = colour(t.accent);
  c[ImGuiCol_TextSelectedBg] = colour(t.selection);
}

}  // namespace gbl::ui
