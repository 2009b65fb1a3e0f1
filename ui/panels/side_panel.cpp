#include "ui/panels/side_panel.h"

#include <algorithm>

#include "ui/key_spec.h"

namespace gbl::ui {
namespace {

struct Hint {
  Box box;
  const PanelKey* row;
  std::string cap;
};

std::vector<Hint> flow_of_hints(const Box& box, float px, std::span<const PanelKey> keys) {
  std::vector<Hint> hints;
  ImVec2 at = box.min;
  for (const PanelKey& k : keys) {
    const std::string cap = printed_keys(k.key);
    const float width = key_cap_width(cap, px) + px * 0.4f + text_size(k.words, px).x;
    if (at.x > box.min.x && at.x + width > box.max.x) at = {box.min.x, at.y + std::round(line_height(px) * 1.12f)};
    hints.push_back({{at, {at.x + width, at.y + line_height(px)}}, &k, cap});
    at.x += width + px;
  }
  return hints;
}

}  // namespace

Box side_box(const FrameContext& f) {
  const Box& canvas = f.layout.canvas;
  return {{canvas.min.x + std::round(800 * f.layout.unit), canvas.min.y}, {canvas.max.x, f.layout.status.min.y}};
}

Box edge_box(const FrameContext& f) {
  const Box& canvas = f.layout.canvas;
  const float design = f.type.body / f.layout.unit > 18 ? 800 : 400;  // large type needs the place of four pictures
  return {{canvas.max.x - std::round(design * f.layout.unit), canvas.min.y}, {canvas.max.x, f.layout.status.min.y}};
}

// A cap and words beside it, in one line.
void draw_keyed(Painter& p, const Box& box, float px, std::string_view key, ImU32 colour, std::string_view words) {
  const float left = box.min.x + p.key_cap(box.min, px, key) + px * 0.5f;
  p.text_in({{left, box.min.y + above_text(px)}, {box.max.x, box.max.y + px}}, px, colour, words);
}

void draw_panel_keys(FrameContext& f, Painter& p, const Box& box, std::span<const PanelKey> keys) {
  float px = f.type.small;
  std::vector<Hint> hints = flow_of_hints(box, px, keys);
  while (px > kSmallestPx && hints.back().box.max.y > box.max.y) hints = flow_of_hints(box, px -= 1, keys);
  if (hints.back().box.max.y > box.max.y + 1) f.state.cut_texts.emplace_back("the panel's keys");
  for (const Hint& h : hints) {
    const float cap = p.key_cap(h.box.min, px, h.cap);
    p.text({h.box.min.x + cap + px * 0.4f, h.box.min.y + above_text(px)}, px, theme().dim, h.row->words);
    if (h.cap.size() > 1) continue;  // several keys: not one button
    if (hit_area(h.row->words, h.box)) h.row->run(f, {h.cap});
  }
}

}  // namespace gbl::ui
