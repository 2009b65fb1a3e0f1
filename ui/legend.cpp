// Legends on the pictures: swatches in a row, or a bar with numbers (lying, or standing where its labels are long).
#include <algorithm>
#include <cmath>

#include "ui/style.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

ImU32 packed(glm::vec3 c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1}); }

struct Metrics {
  float px, line, gap, swatch;
  explicit Metrics(float size)
      : px(size), line(std::round(size * 1.28f)), gap(std::round(size * 0.4f)), swatch(std::round(size * 0.8f)) {}
};

float label_width(const LegendEntry& e, const Metrics& m) { return text_size(e.label, m.px).x; }

float row_width(const std::vector<LegendEntry>& entries, const Metrics& m) {
  float width = 0;
  for (const LegendEntry& e : entries) width += m.swatch + m.gap / 2 + label_width(e, m) + 2 * m.gap;
  return width;
}

void draw_row(Painter& p, ImVec2 at, const std::vector<LegendEntry>& entries, const Metrics& m) {
  for (const LegendEntry& e : entries) {
    const float top = at.y + (m.line - m.swatch) / 2;
    const Box swatch{{at.x, top}, {at.x + m.swatch, top + m.swatch}};
    p.fill(swatch, packed(e.colour));
    p.outline(swatch, on_picture().dim, 1);  // black on dark is a swatch, too
    at.x += m.swatch + m.gap / 2;
    at.x += p.text({at.x, at.y + above_text(m.px)}, m.px, on_picture().text, e.label).x + 2 * m.gap;
  }
}

// Labels below a lying bar start at their ticks; the last one reaches out beyond the bar's end.
bool labels_apart(const std::vector<LegendEntry>& entries, float bar, const Metrics& m) {
  const float step = bar / static_cast<float>(entries.size() - 1);
  float room = 0;  // to the next label on the right; entries without one only lend their colour
  for (auto e = entries.rbegin() + 1; e != entries.rend(); ++e) {
    room += step;
    if (e->label.empty()) continue;
    if (label_width(*e, m) + m.gap > room) return false;
    room = 0;
  }
  return true;
}

void fill_bar(Painter& p, const Box& bar, const std::vector<LegendEntry>& entries, bool lying) {
  const float n = static_cast<float>(entries.size() - 1);
  for (size_t i = 0; i + 1 < entries.size(); ++i) {
    const float a = static_cast<float>(i) / n, b = static_cast<float>(i + 1) / n;
    const ImU32 from = packed(entries[i].colour), to = packed(entries[i + 1].colour);
    if (lying)
      p.list().AddRectFilledMultiColor({bar.min.x + bar.width() * a, bar.min.y},
                                       {bar.min.x + bar.width() * b, bar.max.y}, from, to, to, from);
    else
      p.list().AddRectFilledMultiColor({bar.min.x, bar.max.y - bar.height() * b},
                                       {bar.max.x, bar.max.y - bar.height() * a}, to, to, from, from);
  }
  p.outline(bar, on_picture().dim, 1);
}

void draw_lying_bar(Painter& p, const Box& panel, const Legend& legend, float bar, const Metrics& m) {
  const float beyond = std::max(label_width(legend.entries.back(), m), row_width(legend.apart, m));
  const Box back{{panel.min.x + 2, panel.max.y - 2 - m.swatch - m.line - 2 * m.gap},
                 {panel.min.x + 2 + bar + beyond + 2 * m.gap, panel.max.y - 2}};
  p.fill(back, on_picture().backing);
  const ImVec2 at{back.min.x + m.gap, back.min.y + m.gap};
  fill_bar(p, {at, {at.x + bar, at.y + m.swatch}}, legend.entries, true);
  const float step = bar / static_cast<float>(legend.entries.size() - 1);
  for (size_t i = 0; i < legend.entries.size(); ++i) {
    const float x = at.x + step * static_cast<float>(i);
    if (legend.entries[i].label.empty()) continue;
    p.list().AddLine({x, at.y}, {x, at.y + m.swatch + m.gap}, on_picture().dim);
    p.text({x + 3, at.y + m.swatch + above_text(m.px)}, m.px, on_picture().text, legend.entries[i].label);
  }
  draw_row(p, {at.x + bar + 2 * m.gap, at.y + (m.swatch - m.line) / 2}, legend.apart, m);
}

void draw_standing_bar(Painter& p, const Box& panel, const Legend& legend, const Metrics& m) {
  const float rows = static_cast<float>(legend.entries.size() + (legend.apart.empty() ? 0 : 1));
  float width = legend.apart.empty() ? 0 : row_width(legend.apart, m);
  for (const LegendEntry& e : legend.entries) width = std::max(width, m.swatch + m.gap + label_width(e, m));
  const Box back{{panel.min.x + 2, panel.max.y - 2 - rows * m.line - 2 * m.gap},
                 {panel.min.x + 2 + width + 2 * m.gap, panel.max.y - 2}};
  p.fill(back, on_picture().backing);
  const ImVec2 at{back.min.x + m.gap, back.min.y + m.gap};
  const size_t n = legend.entries.size();
  // The bar's ends stand at the middle of the first and last label.
  fill_bar(p, {{at.x, at.y + m.line / 2}, {at.x + m.swatch, at.y + (static_cast<float>(n) - 0.5f) * m.line}},
           legend.entries, false);
  for (size_t i = 0; i < n; ++i)
    p.text({at.x + m.swatch + m.gap, at.y + static_cast<float>(n - 1 - i) * m.line + above_text(m.px)}, m.px,
           on_picture().text, legend.entries[i].label);
  draw_row(p, {at.x, at.y + static_cast<float>(n) * m.line}, legend.apart, m);
}

}  // namespace

void draw_legend(Painter& p, const Box& panel, const Legend& legend, float px) {
  if (legend.entries.size() < (legend.bar ? 2u : 1u)) return;
  const float room = panel.width() - 4;
  if (!legend.bar) {
    while (px > kSmallestPx && row_width(legend.entries, Metrics(px)) > room) px -= 1;
    const Metrics m(px);
    const Box back{{panel.min.x + 2, panel.max.y - 2 - m.line - m.gap},
                   {panel.min.x + 2 + row_width(legend.entries, m), panel.max.y - 2}};
    p.fill(back, on_picture().backing);
    return draw_row(p, {back.min.x + m.gap, back.min.y + m.gap / 2}, legend.entries, m);
  }
  const Metrics m(px);
  const float beyond = std::max(label_width(legend.entries.back(), m), row_width(legend.apart, m) + 2 * m.gap);
  const float bar = std::min(px * 22, room - beyond - 2 * m.gap);
  if (labels_apart(legend.entries, bar, m)) return draw_lying_bar(p, panel, legend, bar, m);
  // A standing bar takes little more than half the panel's height.
  const float rows = static_cast<float>(legend.entries.size() + legend.apart.size());
  draw_standing_bar(p, panel, legend,
                    Metrics(std::max(kSmallestPx, std::min(px, std::floor(panel.height() * 0.55f / rows / 1.28f)))));
}

}  // namespace gbl::ui
