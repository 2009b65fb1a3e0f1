// F1: every key, from the rows that the dispatch reads, and what the mouse does. Each can be chosen here as well: where there is
// no keyboard, it is the way to all of them.
#include <algorithm>
#include <fmt/format.h>

#include "ui/key_spec.h"
#include "ui/keys.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

float caps_width(const std::vector<std::string>& caps, float px) {
  float width = 0;
  for (const std::string& c : caps) width += key_cap_width(c, px) + 3;
  return width;
}

struct Columns {
  float px, keys, text, gap;
  float height(const KeyRow& r) const { return std::max(line_height(px), text_size(r.help, px, text).y) + gap; }
};

constexpr int kColumns = 3;

Columns columns_at(float px, const std::vector<KeyRow>& rows, float width) {
  Columns c{px, 0, 0, std::round(px * 0.5f)};
  for (const KeyRow& r : rows) c.keys = std::max(c.keys, caps_width(key_caps(r.key), px));
  c.text = width / kColumns - c.keys - 2.5f * px;
  return c;
}

// How many rows stand in each column when none is higher than `most`; empty if they do not fit.
std::vector<size_t> split(const std::vector<KeyRow>& rows, const Columns& c, float most) {
  std::vector<size_t> ends;
  float y = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (y + c.height(rows[i]) > most) {
      ends.push_back(i);
      y = 0;
    }
    y += c.height(rows[i]);
  }
  ends.push_back(rows.size());
  return ends.size() <= kColumns ? ends : std::vector<size_t>{};
}

// What a place of the list does when it is clicked: as if that key were pressed once the list is closed.
void choose_by_click(FrameContext& f, Painter& p, const Box& box, const KeyEvent& e) {
  ImGui::SetCursorScreenPos(box.min);
  ImGui::PushID(fmt::format("{}{}{}", e.ctrl, e.shift, e.key).c_str());
  const bool clicked = ImGui::InvisibleButton("choose", {std::max(box.width(), 1.0f), std::max(box.height(), 1.0f)});
  if (ImGui::IsItemHovered()) p.fill(box, theme().hovered, 3);
  ImGui::PopID();
  if (!clicked) return;
  press_panel(f, panel("help"), {});
  f.state.chosen.push_back(e);
}

// A row does its key; of several keys each cap does its own.
void row_buttons(FrameContext& f, Painter& p, const Box& row_box, const KeyRow& r, float px) {
  if (!r.can_choose) return;
  const std::vector<KeyEvent> presses = presses_of(r);
  const std::vector<std::string> caps = key_caps(r.key);
  if (presses.size() == 1 || caps.size() < presses.size()) return choose_by_click(f, p, row_box, presses.front());
  float x = row_box.min.x;
  for (size_t i = 0; i < caps.size(); ++i) {
    const float width = key_cap_width(caps[i], px);
    const size_t before = caps.size() - presses.size();  // "Shift"
    if (i >= before) choose_by_click(f, p, {{x, row_box.min.y}, {x + width, row_box.max.y}}, presses[i - before]);
    x += width + 3;
  }
}

Box help_box(const FrameContext& f) { return {f.layout.canvas.min, {f.layout.canvas.max.x, f.layout.status.min.y}}; }

void draw_help(FrameContext& f, Painter& p, const Box& box) {
  const Box room = box.inset(std::round(24 * f.layout.unit));
  const float head = line_height(f.type.large) * 1.4f;
  p.text_in({room.min, {room.max.x, room.min.y + head}}, f.type.large, theme().accent,
            "Keys and mouse   (click one to press it; F1 or Esc closes; Shift with a letter goes backwards)");
  std::vector<KeyRow> rows = key_rows();
  for (KeyRow& r : mouse_rows()) rows.push_back(std::move(r));
  const float height = room.height() - head;
  Columns c = columns_at(std::round(f.type.body * 1.4f), rows, room.width());
  while (split(rows, c, height).empty() && c.px > kSmallestPx) c = columns_at(c.px - 1, rows, room.width());
  std::vector<size_t> ends = split(rows, c, height);
  // The lowest columns that hold them all: three alike instead of two and a bit.
  for (float most = height - c.px; !split(rows, c, most).empty(); most -= c.px) ends = split(rows, c, most);
  if (ends.empty()) f.state.cut_texts.emplace_back("the list of keys");
  size_t i = 0;
  for (size_t column = 0; column < ends.size(); ++column) {
    ImVec2 at{room.min.x + static_cast<float>(column) * room.width() / kColumns, room.min.y + head};
    for (; i < ends[column]; ++i) {
      const float height_of_row = c.height(rows[i]);
      row_buttons(f, p, {at, {at.x + c.keys + c.px + c.text, at.y + height_of_row - c.gap / 2}}, rows[i], c.px);
      float x = at.x;
      for (const std::string& cap : key_caps(rows[i].key)) x += p.key_cap({x, at.y}, c.px, cap) + 3;
      p.text({at.x + c.keys + c.px, at.y + above_text(c.px)}, c.px, theme().text, rows[i].help, c.text);
      at.y += height_of_row;
    }
  }
}

}  // namespace

extern const Panel kHelpPanel = {
    .key = "F1", .id = "help", .help = "these keys", .place = Place::whole, .box = help_box, .draw = draw_help};

}  // namespace gbl::ui
