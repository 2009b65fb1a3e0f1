// A contact sheet: a title, the settings in words, and the panels of the window with a caption below each.
#include <algorithm>
#include <cmath>

#include "ui/state.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

constexpr float kMargin = 16, kGap = 12;

// Sizes are needed before there is a font: a letter of DejaVu Sans is .6 em wide on average, .66 is on the safe side.
float lines_for(std::string_view text, float px, float width) {
  if (text.empty()) return 0;
  float lines = 1;
  for (const char c : text) lines += c == '\n' ? 1.0f : 0.0f;
  return std::max(lines, std::ceil(static_cast<float>(text.size()) * 0.66f * px / width));
}

struct SheetLayout {
  Type type;
  float width, head, title, picture, caption;
  int columns, rows;
};

SheetLayout lay_out(const Sheet& sheet, const Settings& s) {
  SheetLayout l;
  l.type = type_for(std::clamp(sheet.tile_width / 480, 0.8f, 1.6f));
  const int n = std::max<int>(1, static_cast<int>(sheet.tiles.size()));
  l.columns = std::clamp(sheet.columns, 1, n);
  l.rows = (n + l.columns - 1) / l.columns;
  l.width = 2 * kMargin + static_cast<float>(l.columns) * (sheet.tile_width + kGap) - kGap;
  l.picture = std::round(sheet.tile_width * static_cast<float>(s.size.y) / static_cast<float>(s.size.x));
  const float room = l.width - 2 * kMargin;
  l.title = lines_for(sheet.title, l.type.large, room) * line_height(l.type.large);
  l.head = kMargin + l.title + lines_for(sheet.caption, l.type.body, room) * line_height(l.type.body);
  if (l.head > kMargin) l.head += kGap;
  float lines = 0;
  for (const SheetTile& t : sheet.tiles) lines = std::max(lines, lines_for(t.caption, l.type.body, sheet.tile_width));
  l.caption = lines > 0 ? lines * line_height(l.type.body) + 6 : 0;
  return l;
}

}  // namespace

glm::ivec2 sheet_size(const Sheet& sheet, const Settings& s) {
  const SheetLayout l = lay_out(sheet, s);
  const float height = l.head + static_cast<float>(l.rows) * (l.picture + l.caption + kGap) - kGap + kMargin;
  return {static_cast<int>(std::ceil(l.width)), static_cast<int>(std::ceil(height))};
}

void draw_sheet(const Sheet& sheet, const Settings& s, const Input& in) {
  std::vector<std::string> cut_texts;
  Painter p(*ImGui::GetBackgroundDrawList(), cut_texts);
  const SheetLayout l = lay_out(sheet, s);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  p.fill({{0, 0}, display}, theme().background);
  const float right = l.width - kMargin;
  p.text_in({{kMargin, kMargin}, {right, l.head}}, l.type.large, theme().text, sheet.title, true);
  p.text_in({{kMargin, kMargin + l.title}, {right, l.head}}, l.type.body, theme().dim, sheet.caption, true);
  for (size_t i = 0; i < sheet.tiles.size(); ++i) {
    const SheetTile& tile = sheet.tiles[i];
    const float column = static_cast<float>(static_cast<int>(i) % l.columns),
                line = static_cast<float>(static_cast<int>(i) / l.columns);
    const ImVec2 min{kMargin + column * (sheet.tile_width + kGap), l.head + line * (l.picture + l.caption + kGap)};
    const Box panel{min, {min.x + sheet.tile_width, min.y + l.picture}};
    PanelLook look;
    look.px = l.type.small;
    if (tile.overlaid) look.overlays = overlay_legends(tile.view, s, in);
    draw_view_panel(p, panel, tile.view, tile.image, s, legend_now(tile.view, s, in), look);
    p.text_in({{min.x, panel.max.y + 4}, {panel.max.x, panel.max.y + l.caption}}, l.type.body, theme().text,
              tile.caption, true);
  }
}

}  // namespace gbl::ui
