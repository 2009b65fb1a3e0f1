#include "ui/overlay_legends.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/inspect/view_buffers.h"
#include "ui/style.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

std::string share_text(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string classes_in_words(std::span<const ViewClass> classes, const ViewStats& stats) {
  std::string text;
  for (size_t i = 1; i < classes.size(); ++i)
    if (stats.whole[i] > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", classes[i].label,
                          share_text(double(stats.whole[i]) / double(stats.pixels)));
  return text.empty() ? "none" : text;
}

}  // namespace

std::string marked_in_words(View v, const ViewStats* stats) {
  const ViewRow& r = row(v);
  if (!stats || stats->pixels == 0) return "";
  if (v == View::miscounted_pairs) {
    if (stats->min.x == 0 && stats->max.x == 0) return "none";
    return fmt::format("{} of the pixels, {:g} to {:+g} lights", share_text(stats->marked()), stats->min.x,
                       stats->max.x);
  }
  if (v == View::triangle_size)
    return fmt::format("{:.3g} to {:.3g} px, {:.3g} in the mean", stats->min.x, stats->max.x, stats->mean.x);
  if (!r.classes.empty()) return classes_in_words(r.classes, *stats);
  if (r.legend == count_legend) return fmt::format("{:.3g} in the mean, at most {:g}", stats->mean.x, stats->largest());
  return r.marks ? fmt::format("{} of the pixels", share_text(stats->marked())) : "";
}

std::vector<OverlayLegend> overlay_legends(View under, const Settings& s, const Input& in) {
  std::vector<OverlayLegend> out;
  for (auto o = s.view.overlays.rbegin(); o != s.view.overlays.rend(); ++o) {
    const View v = view_by_id(o->view).view;
    if (v == under) continue;
    const std::string why = why_not_over(v, s);
    OverlayLegend one{fmt::format("{} {:.0f} %", row(v).label, 100 * o->opacity), why, {}};
    if (why.empty()) {
      one.words = marked_in_words(v, in.stats[static_cast<size_t>(v)]);
      one.legend = legend_now(v, s, in);
      if (row(v).marks && !one.legend.bar && !row(v).classes.empty())
        one.legend.entries.erase(one.legend.entries.begin());  // what it leaves alone has no colour
    }
    out.push_back(std::move(one));
  }
  return out;
}

float draw_overlay_legends(Painter& p, const Box& panel, float top, const std::vector<OverlayLegend>& all, float px) {
  for (const OverlayLegend& o : all) {
    const float pad = std::round(px * 0.4f), line = line_height(px);
    const std::string text = o.words.empty() ? o.name : fmt::format("{}: {}", o.name, o.words);
    const float room = panel.width() - 4;
    float size = px;
    while (size > kSmallestPx && text_size(text, size).x + 2 * pad > room) size -= 1;
    const Box back{{panel.min.x + 2, top}, {panel.min.x + 2 + text_size(text, size).x + 2 * pad, top + line + 2}};
    p.fill(back, on_picture().backing);
    p.text({back.min.x + pad, top + 1 + above_text(px)}, size, on_picture().text, text);
    top = back.max.y + 1;
    if (o.legend.entries.empty() || o.legend.bar) continue;
    draw_legend(p, {{panel.min.x, top}, {panel.max.x, top + std::round(px * 1.28f) + pad + 4}}, o.legend, px);
    top += std::round(px * 1.28f) + pad + 3;
  }
  return top;
}

}  // namespace gbl::ui
