#include "ui/view_panel.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/style.h"

namespace gbl::ui {
namespace {

// Key, name, format and bytes on the picture's top edge.
struct Badge {
  std::string_view key, name;
  std::string stored;
  float px, pad;
  Box back;
};

// Where the panel is too narrow for all, the attachment's name goes first: its format and bytes are what the lecture is
// about.
Badge badge_of(const Box& panel, const ViewRow& view, std::string stored, const PanelLook& look) {
  const std::string_view name = look.name.empty() ? view.label : look.name;
  const float pad = std::round(look.px * 0.4f);
  const float room = panel.width() - 6 * pad;
  const auto width = [&](float px) {
    return text_size(view.key, px).x + text_size(name, px).x + text_size(stored, px).x + 2 * pad;
  };
  const size_t space = stored.find(' ');
  if (width(look.px) > room && space != std::string::npos) stored.erase(0, space + 1);
  float px = look.px;
  while (px > kSmallestPx && width(px) > room) px -= 1;
  const ImVec2 at{panel.min.x + 2, panel.min.y + 2};
  const Box back{at, {at.x + width(px) + 5 * pad, at.y + std::round(px * 1.28f) + 2}};
  return {view.key, name, std::move(stored), px, pad, back};
}

void draw_badge(Painter& p, const Box& panel, const ViewRow& view, std::string stored, const PanelLook& look) {
  const Badge b = badge_of(panel, view, std::move(stored), look);
  p.fit(b.name, {panel.width() - 6 * b.pad, panel.height()}, b.px, false);  // notes a name that no size fits
  p.fill(b.back, on_picture().backing);
  p.fill({b.back.min, {b.back.min.x + b.pad, b.back.max.y}}, pass_colour(view.written_by, on_picture()));
  ImVec2 at{b.back.min.x + 2 * b.pad, b.back.min.y + 1 + above_text(b.px)};
  if (!b.key.empty()) at.x += p.text(at, b.px, on_picture().accent, b.key).x + b.pad;
  at.x += p.text(at, b.px, on_picture().text, b.name).x + 2 * b.pad;
  p.text(at, b.px, on_picture().dim, b.stored);
}

void draw_missing(Painter& p, const Box& panel, const std::string& why, const PanelLook& look) {
  p.fill(panel, theme().surface);
  const Box room{{panel.min.x + panel.width() * 0.1f, panel.min.y + panel.height() * 0.3f},
                 {panel.max.x - panel.width() * 0.1f, panel.max.y - panel.height() * 0.1f}};
  draw_paragraphs(p, room, {{"Not stored", theme().accent, look.px * 1.3f}, {why, theme().text, look.px * 1.1f}},
                  look.px * 0.4f);
}

}  // namespace

Box picture_box(const Box& panel, glm::ivec2 picture) {
  if (picture.x <= 0 || picture.y <= 0) return panel;
  const float shape = static_cast<float>(picture.x) / static_cast<float>(picture.y);
  const float room = panel.width() / panel.height();
  if (std::abs(shape / room - 1) < 0.01f) return panel;  // rounding of sizes: fill the panel
  const ImVec2 size =
      shape > room ? ImVec2{panel.width(), panel.width() / shape} : ImVec2{panel.height() * shape, panel.height()};
  const ImVec2 min{std::round(panel.min.x + (panel.width() - size.x) / 2),
                   std::round(panel.min.y + (panel.height() - size.y) / 2)};
  return {min, {min.x + std::round(size.x), min.y + std::round(size.y)}};
}

Box badge_box(const Box& panel, View v, const Settings& s, float px) {
  PanelLook look;
  look.px = px;
  return badge_of(panel, row(v), stored_as(v, s), look).back;
}

Legend legend_now(View v, const Settings& s, const Input& in) {
  if (v == View::error && in.error) return error_legend(*in.error, s.view.error.scale);
  return legend(v, s, in.scene.bounds, in.stats[static_cast<size_t>(v)]);
}

void draw_view_panel(Painter& p, const Box& panel, View v, const ViewImage& image, const Settings& s,
                     const Legend& legend, const PanelLook& look) {
  const ViewRow& view = row(v);
  const std::string why = why_missing(v, s);
  p.list().PushClipRect(panel.min, panel.max, true);
  if (!why.empty()) {
    draw_missing(p, panel, why, look);
  } else {
    p.fill(panel, IM_COL32(0, 0, 0, 255));
    const Box picture = picture_box(panel, image.size);
    const glm::vec2 first(look.zoom.first()), last = first + 1 / static_cast<float>(look.zoom.scale);
    const ImVec2 top_left{first.x, 1 - first.y}, bottom_right{last.x, 1 - last.y};  // GL's rows go up
    if (image.texture)
      p.list().AddImage(reinterpret_cast<ImTextureID>(image.texture), picture.min, picture.max, top_left, bottom_right);
    if (look.over) look.over(p);
  }
  const float thickness = std::max(2.0f, std::round(panel.width() / 300));
  p.outline(panel, pass_colour(view.written_by, on_picture()), thickness);
  if (look.chosen) p.outline(panel.inset(thickness), on_picture().accent, thickness);
  if (look.words) {
    Box room = panel.inset(look.chosen ? thickness * 2 - 2 : 0);
    room.max.y -= look.foot;
    draw_badge(p, room, view, why.empty() ? stored_as(v, s) : "", look);
    draw_legend(p, room, legend, look.px);
    const float below_badge = room.min.y + 6 + std::round(look.px * 1.28f);
    if (why.empty()) draw_overlay_legends(p, room, below_badge, look.overlays, look.px);
  }
  p.list().PopClipRect();
}

}  // namespace gbl::ui
