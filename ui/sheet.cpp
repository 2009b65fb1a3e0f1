#include "ui/sheet.h"

#include <algorithm>
#include <cmath>

#include "ui/pixel_numbers.h"
#include "ui/style.h"

namespace gbl::ui {
namespace {

constexpr float kMargin = 16, kGap = 12;  // at scale 1

// Sizes are needed before there is a font: a letter of DejaVu Sans is .6 em wide on average, .66 is on the safe side.
float lines_for(std::string_view text, float px, float width) {
  if (text.empty()) return 0;
  float lines = 1;
  for (const char c : text) lines += c == '\n' ? 1.0f : 0.0f;
  return std::max(lines, std::ceil(static_cast<float>(text.size()) * 0.66f * px / width));
}

struct SheetLayout {
  Type type;
  float margin, gap, width, head, title, picture, caption;
  int columns, rows;
};

float shape_of(const SheetTile& t) {
  return t.image.size.x > 0 ? static_cast<float>(t.image.size.y) / static_cast<float>(t.image.size.x) : 9.0f / 16;
}

SheetLayout lay_out(const Sheet& sheet) {
  SheetLayout l;
  l.type = type_for(std::clamp(sheet.tile_width / 480, 0.8f * sheet.scale, 1.6f * sheet.scale));
  l.margin = std::round(kMargin * sheet.scale), l.gap = std::round(kGap * sheet.scale);
  const int n = std::max<int>(1, static_cast<int>(sheet.tiles.size()));
  l.columns = std::clamp(sheet.columns, 1, n);
  l.rows = (n + l.columns - 1) / l.columns;
  l.width = 2 * l.margin + static_cast<float>(l.columns) * (sheet.tile_width + l.gap) - l.gap;
  float tallest = 0, lines = 0;
  for (const SheetTile& t : sheet.tiles) {
    tallest = std::max(tallest, shape_of(t));
    lines = std::max(lines, lines_for(t.caption, l.type.body, sheet.tile_width));
  }
  l.picture = std::round(sheet.tile_width * tallest);
  const float room = l.width - 2 * l.margin;
  l.title = lines_for(sheet.title, l.type.large, room) * line_height(l.type.large);
  l.head = l.margin + l.title + lines_for(sheet.caption, l.type.body, room) * line_height(l.type.body);
  if (l.head > l.margin) l.head += l.gap;
  l.caption = lines > 0 ? lines * line_height(l.type.body) + std::round(6 * sheet.scale) : 0;
  return l;
}

void add_picture(Painter& p, const Box& box, const ViewImage& image, const Zoom& zoom) {
  const glm::vec2 first(zoom.first()), last = first + 1 / static_cast<float>(zoom.scale);
  p.list().AddImage(reinterpret_cast<ImTextureID>(image.texture), box.min, box.max, {first.x, 1 - first.y},
                    {last.x, 1 - last.y});  // GL's rows go up
}

void draw_inset(Painter& p, const Box& picture, const SheetTile& t, float scale) {
  const float line = std::round(2 * scale), gap = std::round(6 * scale);
  const ImVec2 size{std::round(picture.width() * 0.4f), std::round(picture.height() * 0.4f)};
  const ImVec2 min{t.inset->right ? picture.max.x - gap - size.x : picture.min.x + gap,
                   t.inset->top ? picture.min.y + gap : picture.max.y - gap - size.y};
  const Box box{min, {min.x + size.x, min.y + size.y}};
  const glm::vec2 first(in_panel(t.zoom, t.inset->zoom.first())),
      last(in_panel(t.zoom, t.inset->zoom.first() + 1 / t.inset->zoom.scale));
  const Box from{{picture.min.x + first.x * picture.width(), picture.min.y + first.y * picture.height()},
                 {picture.min.x + last.x * picture.width(), picture.min.y + last.y * picture.height()}};
  for (const Box& b : {from, box})
    p.outline({{b.min.x - line, b.min.y - line}, {b.max.x + line, b.max.y + line}}, IM_COL32_BLACK, line);
  p.outline(from, on_picture().accent, line);
  add_picture(p, box, t.image, t.inset->zoom);
  p.outline(box, on_picture().accent, line);
}

void draw_label(Painter& p, const Box& side, bool at_right, const std::string& text, float px) {
  if (text.empty()) return;
  const float pad = std::round(px * 0.4f), width = text_size(text, px).x + 2 * pad, height = line_height(px) + 2;
  const ImVec2 min{at_right ? side.max.x - pad - width : side.min.x + pad, side.max.y - pad - height};
  p.fill({min, {min.x + width, min.y + height}}, on_picture().backing);
  p.text({min.x + pad, min.y + 1 + above_text(px)}, px, on_picture().accent, text);
}

void draw_against(Painter& p, const Box& picture, const SheetTile& t, float px, float scale) {
  const float x = std::round(picture.min.x + static_cast<float>(t.against->from) * picture.width());
  const Box left{picture.min, {x, picture.max.y}}, right{{x, picture.min.y}, picture.max};
  p.list().PushClipRect(right.min, right.max, true);
  add_picture(p, picture, t.against->image, t.zoom);
  p.list().PopClipRect();
  p.list().AddLine({x, picture.min.y}, {x, picture.max.y}, IM_COL32_BLACK, 3 * scale);
  p.list().AddLine({x, picture.min.y}, {x, picture.max.y}, on_picture().accent, scale);
  draw_label(p, left, true, t.against->left, px);
  draw_label(p, right, false, t.against->right, px);
}

void draw_tile(Painter& p, const Box& panel, const SheetTile& t, float px, float scale) {
  PanelLook look;
  look.px = px, look.name = t.name, look.zoom = t.zoom, look.overlays = t.overlays;
  const Box picture = picture_box(panel, t.image.size);
  look.over = [&](Painter& over) {
    if (t.against) draw_against(over, picture, t, px, scale);
    if (t.numbers) {
      draw_grid(over, picture, t.zoom, t.image.size);
      draw_numbers(over, picture, t.zoom, t.image.size, *t.numbers, px);
    }
    if (t.inset) draw_inset(over, picture, t, scale);
  };
  draw_view_panel(p, panel, t.view, t.image, t.drawn, t.legend, look);
}

}  // namespace

SheetTile sheet_tile(View v, const ViewImage& image, const Settings& drawn, const Input& in, bool overlaid) {
  SheetTile tile{v, image, drawn, legend_now(v, drawn, in), {}};
  if (overlaid) tile.overlays = overlay_legends(v, drawn, in);
  return tile;
}

glm::ivec2 sheet_size(const Sheet& sheet) {
  const SheetLayout l = lay_out(sheet);
  const float height = l.head + static_cast<float>(l.rows) * (l.picture + l.caption + l.gap) - l.gap + l.margin;
  return {static_cast<int>(std::ceil(l.width)), static_cast<int>(std::ceil(height))};
}

void draw_sheet(const Sheet& sheet) {
  use_theme(sheet.light ? kLightTheme : kDarkTheme);
  std::vector<std::string> cut_texts;
  Painter p(*ImGui::GetBackgroundDrawList(), cut_texts);
  const SheetLayout l = lay_out(sheet);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  p.fill({{0, 0}, display}, sheet.light ? IM_COL32_WHITE : theme().background);
  const float right = l.width - l.margin;
  p.text_in({{l.margin, l.margin}, {right, l.head}}, l.type.large, theme().text, sheet.title, true);
  p.text_in({{l.margin, l.margin + l.title}, {right, l.head}}, l.type.body, theme().dim, sheet.caption, true);
  for (size_t i = 0; i < sheet.tiles.size(); ++i) {
    const SheetTile& tile = sheet.tiles[i];
    const float column = static_cast<float>(static_cast<int>(i) % l.columns),
                line = static_cast<float>(static_cast<int>(i) / l.columns);
    const ImVec2 min{l.margin + column * (sheet.tile_width + l.gap), l.head + line * (l.picture + l.caption + l.gap)};
    const Box panel{min, {min.x + sheet.tile_width, min.y + l.picture}};
    draw_tile(p, panel, tile, l.type.small, sheet.scale);
    p.text_in({{min.x, panel.max.y + 4}, {panel.max.x, panel.max.y + l.caption}}, l.type.body, theme().text,
              tile.caption, true);
  }
}

}  // namespace gbl::ui
