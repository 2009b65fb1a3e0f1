#include "ui/style.h"

#include <cmath>

#include "renderer/base/resources.h"

namespace gbl::ui {
namespace {

// Whole sizes, so that text at 1600×900, at 1280×720, at 1920×1080 and in large type is drawn unscaled or nearly so.
constexpr float kFontSizes[] = {9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 24, 27, 30, 34, 40, 48};

// Beside Latin: Greek for formulas, dashes and …, super- and subscripts, arrows, mathematical signs, ⇧ ⚠ ✓ ▶.
constexpr ImWchar kGlyphs[] = {
#define GLYPHS(first, last) first, last,
#include "ui/glyphs.inc"
#undef GLYPHS
    0};

struct PassLook {
  Pass pass;
  const char* label;
  const char* name;
};
constexpr PassLook kPassLooks[] = {
    {Pass::geometry, "Fill", "geometry pass (Fill)"},
    {Pass::lighting, "Light", "lighting pass (Light)"},
    {Pass::combine, "Combine", "combine pass (Combine)"},
    {Pass::display, "Show", "display transform (Show)"},
};
constexpr bool passes_in_order() {
  for (size_t i = 0; i < std::size(kPassLooks); ++i)
    if (kPassLooks[i].pass != static_cast<Pass>(i)) return false;
  return std::size(kPassLooks) == static_cast<size_t>(Pass::display) + 1;
}
static_assert(passes_in_order());
const PassLook& look_of(Pass pass) { return kPassLooks[static_cast<size_t>(pass)]; }

}  // namespace

ImU32 pass_colour(Pass pass, const Theme& t) { return t.passes[static_cast<size_t>(pass)]; }
const char* pass_label(Pass pass) { return look_of(pass).label; }
const char* pass_name(Pass pass) { return look_of(pass).name; }

Type type_for(float scale) {
  const auto px = [scale](float at_one) { return std::max(9.0f, std::round(at_one * scale)); };
  return {px(13), px(15), px(21)};
}

void set_up_style() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the layout is fixed; nothing to remember between runs
  const std::string_view font = embedded_bytes("fonts/DejaVuSans.ttf");
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  for (const float px : kFontSizes)
    io.Fonts->AddFontFromMemoryTTF(const_cast<char*>(font.data()), static_cast<int>(font.size()), px, &config, kGlyphs);

  use_theme(kDarkTheme);
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {0, 0};
  style.WindowBorderSize = style.WindowRounding = 0;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = 4;
  style.PopupBorderSize = 1;
  style.ItemSpacing = {8, 4};
}

ImFont* font_for(float px) {
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  for (ImFont* font : fonts)
    if (font->FontSize >= px - 0.25f) return font;
  return fonts.back();
}

FontScope::FontScope(float px) {
  ImFont* font = font_for(px);
  ImGui::PushFont(font);
  ImGui::SetWindowFontScale(px / font->FontSize);
}

FontScope::~FontScope() {
  ImGui::SetWindowFontScale(1);
  ImGui::PopFont();
}

}  // namespace gbl::ui
