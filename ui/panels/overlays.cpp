// Ctrl+V: what is laid over the main view, each with a switch, its strength and its number.
#include <algorithm>
#include <fmt/format.h>

#include "ui/overlay_legends.h"
#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

constexpr double kStrengths[] = {0.25, 0.5, kOverlayOpacity, 1};

// Those that are made for it, in the table's order, each with a letter from A on.
std::vector<View> offered() {
  std::vector<View> out;
  for (const ViewRow& v : views())
    if (v.marks || v.view == View::object_id) out.push_back(v.view);
  return out;
}

std::string letter_of(size_t i) { return {static_cast<char>('a' + i)}; }

void lay(FrameContext& f, View v, double opacity) {
  set_overlay(f.settings.view.overlays, row(v).id, opacity);
  const std::string why = why_missing(v, f.stored);
  if (opacity <= 0)
    say(f, {fmt::format("{} is no longer laid over the picture.", capitalised(row(v).label)), ""});
  else if (!why.empty())
    say(f, {fmt::format("{} cannot be shown: {}.", capitalised(row(v).label), why), ""});
  else
    say(f, {fmt::format("{} at {:.0f} %. {}", capitalised(row(v).label), 100 * opacity, row(v).sentence), ""});
}

void toggle(FrameContext& f, View v) {
  lay(f, v, find_overlay(f.settings.view.overlays, row(v).id) ? 0 : kOverlayOpacity);
}

// Shift and its letter: the next strength of those above.
void strengthen(FrameContext& f, View v) {
  const Overlay* now = find_overlay(f.settings.view.overlays, row(v).id);
  const auto* next = std::upper_bound(std::begin(kStrengths), std::end(kStrengths), now ? now->opacity : 0);
  lay(f, v, next == std::end(kStrengths) ? kStrengths[0] : *next);
}

bool press_letter(FrameContext& f, const KeyEvent& e) {
  const std::vector<View> all = offered();
  for (size_t i = 0; i < all.size(); ++i) {
    if (e.ctrl || e.key != letter_of(i)) continue;
    if (!e.repeat) (e.shift ? strengthen : toggle)(f, all[i]);
    return true;
  }
  return false;
}

void take_all_away(FrameContext& f, const KeyEvent&) {
  f.settings.view.overlays.clear();
  say(f, {"Nothing is laid over the picture.", ""});
}

constexpr PanelKey kKeys[] = {{"End", "none", take_all_away}};

void draw_row(FrameContext& f, Painter& p, const Box& line, size_t i, View v, float px) {
  const Overlay* now = find_overlay(f.settings.view.overlays, row(v).id);
  const bool missing = !why_missing(v, f.stored).empty();
  const float half = line.height() / 2, cap = key_cap_width("M", px) + px * 0.6f, slider = line.width() * 0.3f;
  p.key_cap({line.min.x, line.min.y + 2}, px, std::string{static_cast<char>('A' + i)});
  const Box name{{line.min.x + cap, line.min.y}, {line.max.x - slider - px, line.min.y + half}};
  p.text_in(name, px, missing ? theme().dim : now ? theme().accent : theme().text, row(v).label);
  const std::string words = missing ? why_missing(v, f.stored)
                            : now   ? marked_in_words(v, f.input.stats[static_cast<size_t>(v)])
                                    : "";
  p.text_in({{name.min.x, line.min.y + half}, {line.max.x, line.max.y}}, f.type.small, theme().dim, words);
  const Box bar{{line.max.x - slider, line.min.y + half * 0.25f}, {line.max.x, line.min.y + half * 0.85f}};
  p.fill(bar, theme().raised, 2);
  const float filled_to = bar.min.x + bar.width() * static_cast<float>(now ? now->opacity : 0);
  if (now) p.fill({bar.min, {filled_to, bar.max.y}}, theme().accent, 2);
  const std::string percent = now ? fmt::format("{:.0f} %", 100 * now->opacity) : "off";
  const ImVec2 words_at{bar.min.x + px * 0.4f, bar.min.y - 1};
  p.text(words_at, f.type.small, theme().text, percent);
  if (now) {  // the part of it that lies on the filled part
    p.list().PushClipRect(bar.min, {filled_to, bar.max.y}, true);
    p.text(words_at, f.type.small, theme().background, percent);
    p.list().PopClipRect();
  }
  if (missing) return;
  if (hit_area(fmt::format("lay.{}", row(v).id).c_str(), {line.min, {bar.min.x - px * 0.5f, line.max.y}})) toggle(f, v);
  hit_area(fmt::format("strength.{}", row(v).id).c_str(), bar);
  if (!ImGui::IsItemActive()) return;
  const double to = (ImGui::GetIO().MousePos.x - bar.min.x) / double(bar.width());
  set_overlay(f.settings.view.overlays, row(v).id, to < 0.03 ? 0 : std::round(std::min(to, 1.0) * 100) / 100);
}

void draw_overlays(FrameContext& f, Painter& p, const Box& box) {
  Shelf shelf{box.inset(std::round(12 * f.layout.unit)), 0};
  p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent, "Laid over the main view");
  const Box hints = shelf.above(4 * line_height(f.type.small));
  const std::vector<View> all = offered();
  const float height = std::min(f.type.body * 3, shelf.room.height() / static_cast<float>(all.size()));
  const float px = std::max(kSmallestPx, std::floor(std::min(f.type.body, height * 0.42f)));
  for (size_t i = 0; i < all.size(); ++i) draw_row(f, p, shelf.below(height), i, all[i], px);
  draw_paragraphs(p, hints,
                  {{"A letter lays it on or takes it away, Shift and the letter its next strength; End takes "
                    "all away. V: wires of the light volumes. , . pick the light. Ctrl+V or Esc closes.",
                    theme().dim, f.type.small}},
                  2);
}

}  // namespace

extern const Panel kOverlaysPanel = {.key = "Ctrl+V",
                                     .id = "overlays",
                                     .help = "what is laid over the main view: footprints, wires, counts, checks",
                                     .place = Place::edge,
                                     .box = edge_box,
                                     .draw = draw_overlays,
                                     .keys = kKeys,
                                     .press_other = press_letter};

}  // namespace gbl::ui
