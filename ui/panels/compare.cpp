// Ctrl+B: what B is, how A and B are compared, and what they differ in.
#include <fmt/format.h>

#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

void to_now(FrameContext& f, const KeyEvent&) { set_b(f, f.settings, "the state as it is now"); }
void to_last(FrameContext& f, const KeyEvent&) {
  const Settings* last = f.state.history.last();
  if (!last) return say(f, {"Nothing was changed yet: there is no state before.", ""});
  set_b(f, *last, "the state before the last change");
}
void to_sound(FrameContext& f, const KeyEvent&) { set_b(f, cured(f.settings), "A with every choice sound"); }
void to_loaded(FrameContext& f, const KeyEvent&) { set_b(f, f.state.initial, "the state as it was loaded"); }
void to_truth(FrameContext& f, const KeyEvent&) {
  Comparison& c = f.state.comparison;
  c.what = BesideA::truth, c.other.reset(), c.b_drawn = false;
  if (c.mode == CompareMode::off) c.mode = CompareMode::wipe;
  say(f, {"B is the truth: the finished picture of the reference.", ""});
}
template <CompareMode kMode>
void show_as(FrameContext& f, const KeyEvent& e) {
  if (f.state.comparison.mode == CompareMode::off) next_mode(f, e);
  if (f.state.comparison.has_b()) f.state.comparison.mode = kMode;
}
void with_sign(FrameContext& f, const KeyEvent&) {
  bool& on = f.state.comparison.with_sign;
  on = !on;
  say(f, {on ? "Red: what is drawn is brighter; blue: the other." : "How far they are apart, whichever way.", ""});
}

constexpr PanelKey kKeys[] = {{"L", "B = before the last change", to_last},
                              {"S", "B = A made sound", to_sound},
                              {"T", "B = the truth", to_truth},
                              {"N", "B = A as it is now", to_now},
                              {"H", "B = as loaded", to_loaded},
                              {"W", "wipe", show_as<CompareMode::wipe>},
                              {"I", "side by side", show_as<CompareMode::side_by_side>},
                              {"D", "difference", show_as<CompareMode::difference>},
                              {"G", "difference with sign", with_sign},
                              {"O", "no comparison", show_as<CompareMode::off>}};

void draw_difference_table(FrameContext& f, Painter& p, Shelf& shelf, const Settings& a, const Settings& b) {
  const float px = f.type.small;
  int left_out = 0;
  for (const Option& o : options()) {
    if (!compared(o) || o.get(a) == o.get(b)) continue;
    if (shelf.room.height() < 3 * line_height(px)) {
      ++left_out;
      continue;
    }
    const Box line = shelf.below(line_height(px));
    const float third = line.width() / 3;
    p.text_in({line.min, {line.min.x + third - 4, line.max.y}}, px, theme().dim, o.label);
    p.text_in({{line.min.x + third, line.min.y}, {line.min.x + 2 * third - 4, line.max.y}}, px, theme().text,
              value_text(o, a));
    p.text_in({{line.min.x + 2 * third, line.min.y}, line.max}, px, theme().text, value_text(o, b));
  }
  if (left_out > 0) p.text_in(shelf.below(line_height(px)), px, theme().dim, fmt::format("and {} more", left_out));
}

void draw_compare(FrameContext& f, Painter& p, const Box& box) {
  const Comparison& c = f.state.comparison;
  Shelf shelf{box.inset(std::round(12 * f.layout.unit)), std::round(3 * f.layout.unit)};
  const float px = f.type.body;
  p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent, "A and B");
  const Box keys = shelf.above(10 * line_height(f.type.small));
  p.text_in(
      shelf.below(4 * line_height(px)), px, theme().text,
      "Tab flips, / goes through wipe, side by side and difference. Both keep one camera, one time and one view. A "
      "picture dropped here becomes B. Ctrl+B or Esc closes.",
      true);
  if (c.what == BesideA::settings && c.other) {
    const Settings& a = c.b_drawn ? *c.other : f.settings;
    const Settings& b = c.b_drawn ? f.settings : *c.other;
    const Box head = shelf.below(line_height(f.type.small));
    const float third = head.width() / 3;
    p.text({head.min.x + third, head.min.y}, f.type.small, theme().accent, c.b_drawn ? "A" : "A, drawn");
    p.text({head.min.x + 2 * third, head.min.y}, f.type.small, theme().accent, c.b_drawn ? "B, drawn" : "B");
    draw_difference_table(f, p, shelf, a, b);
  } else {
    p.text_in(shelf.below(2 * line_height(px)), px, theme().dim,
              c.what == BesideA::truth     ? "B is the truth."
              : c.what == BesideA::picture ? "B is " + c.file
                                           : "There is no B yet.",
              true);
  }
  draw_panel_keys(f, p, keys, kKeys);
}

}  // namespace

extern const Panel kComparePanel = {.key = "Ctrl+B",
                                    .id = "compare",
                                    .help = "A and B: what B is, how they are compared, what they differ in",
                                    .place = Place::edge,
                                    .box = edge_box,
                                    .draw = draw_compare,
                                    .keys = kKeys};

}  // namespace gbl::ui
