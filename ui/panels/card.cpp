// H: what a buffer is: one row of the views table, the attachment it reads, and the usual mistake.
#include <fmt/format.h>

#include "ui/state.h"

namespace gbl::ui {
namespace {

struct CardState : PanelState {
  View view = View::final;
};

// "what, how": the channels of the attachment that the view reads.
std::string stored_text(View v, const Settings& s) {
  const std::string why = why_missing(v, s);
  if (!why.empty()) return "not stored: " + why;
  const std::optional<Attachment> a = attachment_of(v, s);
  return a ? fmt::format("{} ({})", stored_as(v, s), a->contents) : stored_as(v, s);
}

// Where it hides something else than the picture that it explains.
Box card_box(const FrameContext& f) {
  if (is_open(f.state, "help") || is_open(f.state, "options")) return {};
  if (f.state.large) return f.layout.column;
  const std::optional<Box>& panel = f.layout.panels[static_cast<size_t>(f.state.of<CardState>().view)];
  const Box& canvas = f.layout.canvas;
  const float middle = f.layout.main_box().max.x, bottom = f.layout.main_box().max.y;
  const bool left = panel && panel->min.x >= middle;
  return left ? Box{canvas.min, {middle, bottom}} : Box{{middle, canvas.min.y}, {canvas.max.x, bottom}};
}

void draw_card(FrameContext& f, Painter& p, const Box& box) {
  const ViewRow& v = row(f.state.of<CardState>().view);
  const Box room = box.inset(std::round(16 * f.layout.unit));
  p.fill({box.min, {box.max.x, box.min.y + 4}}, pass_colour(v.written_by));
  const float head = line_height(f.type.large);
  p.text_in({room.min, {room.max.x, room.min.y + head}}, f.type.large, theme().accent,
            fmt::format("{}{}{}", v.key, *v.key ? "  " : "", v.label));
  const std::vector<Field> fields{{"what", v.sentence, theme().text},
                                  {"space", v.space, theme().text},
                                  {"unit", v.unit, theme().text},
                                  {"range", v.range, theme().text},
                                  {"stored", stored_text(v.view, f.stored), theme().text},
                                  {"written by", pass_name(v.written_by), pass_colour(v.written_by)},
                                  {"read by", v.read_by, theme().text},
                                  {"decode", v.decode, theme().text},
                                  {"in sources", v.in_sources, theme().text},
                                  {"mistake", v.mistake, theme().unsound}};
  const float foot = line_height(f.type.small);
  draw_fields(p, {{room.min.x, room.min.y + head * 1.2f}, {room.max.x, room.max.y - foot}}, fields,
              std::round(f.type.body * 1.3f));
  p.text_in({{room.min.x, room.max.y - foot}, room.max}, f.type.small, theme().dim, "H or Esc closes");
}

void press_card(FrameContext& f, const KeyEvent&) {
  CardState& s = f.state.of<CardState>();
  s.open = !s.open;
  if (s.open) s.view = f.state.hovered.value_or(f.chosen());
}

void turn_card(State& s, View v) { s.of<CardState>().view = v; }

}  // namespace

extern const Panel kCardPanel = {
    .key = "H",
    .id = "card",
    .help = "what is this buffer: the card of the view under the mouse, or of the chosen one",
    .place = Place::over,
    .box = card_box,
    .draw = draw_card,
    .make = make_panel_state<CardState>,
    .press = press_card,
    .follow = turn_card};

}  // namespace gbl::ui
