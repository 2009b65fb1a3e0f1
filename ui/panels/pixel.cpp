// Ctrl+P: the held pixel: what is stored of it, bit by bit, what that means beside the truth, the lights that reach it, and
// the sum written out with the first term that goes wrong.
#include <algorithm>
#include <fmt/format.h>

#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

constexpr float kUsualLines = 36;  // of a whole account

struct PixelState : PanelState {
  size_t first = 0, shown = 0;  // of the lights: the first on screen, and how many in the last frame
};

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double v : values) text += fmt::format("{}{:.6g}", text.empty() ? "" : "  ", v);
  return text;
}

// A table: cells stand below each other, each column as wide as its share says.
class Table {
 public:
  Table(Painter& p, Shelf& shelf, float px, std::vector<float> shares)
      : p_(p), shelf_(shelf), px_(px), shares_(std::move(shares)) {}
  bool row(std::initializer_list<std::pair<std::string_view, ImU32>> cells) {
    if (shelf_.room.height() < line_height(px_)) return false;
    const Box line = shelf_.below(line_height(px_));
    float x = line.min.x;
    size_t k = 0;
    for (const auto& [text, colour] : cells) {
      const float width = line.width() * shares_[k++];
      if (!text.empty()) p_.text_in({{x, line.min.y}, {x + width - px_ * 0.5f, line.max.y}}, px_, colour, text);
      x += width;
    }
    return true;
  }

 private:
  Painter& p_;
  Shelf& shelf_;
  float px_;
  std::vector<float> shares_;
};

void heading(Painter& p, Shelf& shelf, float px, std::string_view text) {
  if (shelf.room.height() < 2 * line_height(px)) return;
  p.text_in(shelf.below(line_height(px)), px, theme().accent, text);
}

void draw_stored(Painter& p, Shelf& shelf, float px, const PixelProbe& probe) {
  heading(p, shelf, px, "stored, hexadecimal");
  Table table(p, shelf, px, {0.24f, 0.1f, 0.28f, 0.38f});
  for (const StoredTexel& t : probe.stored)
    table.row({{t.attachment.name, theme().text},
               {row(t.attachment.format).label, theme().dim},
               {hex(t), theme().text},
               {t.attachment.contents, theme().dim}});
}

void draw_lines(Painter& p, Shelf& shelf, float px, const std::vector<AccountLine>& lines, int first_off) {
  Table table(p, shelf, px, {0.2f, 0.28f, 0.28f, 0.09f, 0.15f});
  table.row(
      {{"", theme().dim}, {"drawn", theme().dim}, {"truth", theme().dim}, {"error", theme().dim}, {"", theme().dim}});
  for (size_t i = 0; i < lines.size(); ++i) {
    const AccountLine& l = lines[i];
    const bool here = static_cast<int>(i) == first_off;
    const std::string drawn = l.drawn.empty() ? "not stored" : numbers(l.drawn), truth = numbers(l.truth);
    const std::string error = l.drawn.empty() ? "" : fmt::format("{:.3g}", l.error);
    const std::string note = here ? fmt::format("{} goes wrong here", kUnsoundSign) : l.unit;
    table.row({{l.what, theme().text},
               {drawn, here ? theme().unsound : theme().text},
               {truth, theme().text},
               {error, here ? theme().unsound : theme().dim},
               {note, here ? theme().unsound : theme().dim}});
  }
}

void draw_lights(Painter& p, Shelf& shelf, float px, const PixelAccount& a, bool in_pixels, PixelState& state) {
  heading(p, shelf, px,
          a.lights.empty() ? "no light reaches it"
                           : fmt::format("{} light{} it, the strongest first", a.lights.size(),
                                         a.lights.size() == 1 ? " reaches" : "s reach"));
  if (a.lights.empty()) return;
  Table table(p, shelf, px, {0.08f, 0.13f, 0.1f, 0.13f, 0.1f, 0.1f, 0.36f});
  table.row({{"light", theme().dim},
             {"distance", theme().dim},
             {"d/r", theme().dim},
             {"arriving", theme().dim},
             {"N.L", theme().dim},
             {"share", theme().dim},
             {"shaded by this method", theme().dim}});
  state.first = std::min(state.first, a.lights.size() - 1);
  state.shown = 0;
  // Forward shading shades surfaces, hidden ones too: no count of it says more.
  for (size_t i = state.first; i < a.lights.size(); ++i) {
    const LightShare& l = a.lights[i];
    const std::string wrong = verdict_of(l);
    const std::string shaded = !l.shaded       ? (i < kCountedLights && in_pixels ? "…" : "not counted")
                               : wrong.empty() ? fmt::format("{}", *l.shaded)
                                               : fmt::format("{} {} {}", *l.shaded, kUnsoundSign, wrong);
    if (!table.row({{fmt::format("{}", l.index), theme().text},
                    {l.distance < kEndless ? fmt::format("{:.5g}", l.distance) : "-", theme().text},
                    {l.range < kEndless ? fmt::format("{:.3f}", l.distance / l.range) : "-", theme().text},
                    {fmt::format("{:.3g}", l.arriving), theme().text},
                    {fmt::format("{:.3f}", l.n_dot_l), theme().text},
                    {fmt::format("{:.1f} %", 100 * l.share), theme().text},
                    {shaded, wrong.empty() ? theme().text : theme().unsound}}))
      break;
    ++state.shown;
  }
}

void draw_pixel(FrameContext& f, Painter& p, const Box& box) {
  Shelf shelf{box.inset(std::round(14 * f.layout.unit)), std::round(2 * f.layout.unit)};
  const float px = f.type.body, small = f.type.small;
  const float table = shelf.room.height() > kUsualLines * line_height(px) ? px : small;
  p.text_in(shelf.above(line_height(small)), small, theme().dim,
            "Ctrl+P or Esc closes   arrows move the pixel   PgUp PgDn: more lights   Ctrl+G goes to a pixel");
  const std::optional<PixelProbe>& probe = f.input.probe;
  if (!probe || !f.state.held_at) {
    p.text_in(shelf.below(3 * line_height(px)), px, theme().text,
              "Click on a picture: the pixel is held and explained here.", true);
    return;
  }
  const std::string_view name = object_name(*probe, f.input.scene);
  p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent,
            fmt::format("pixel {}, {}   {}", probe->pixel.x, probe->pixel.y,
                        !name.empty()      ? name
                        : probe->surface() ? "a surface"
                                           : "the background"));
  draw_stored(p, shelf, table, *probe);
  shelf.below(small * 0.4f);
  const PixelAccount* a = f.input.account;
  if (!a || a->pixel != probe->pixel) {
    p.text_in(shelf.below(line_height(px)), px, theme().accent,
              f.input.truth_progress < 1
                  ? fmt::format("working out the reference: {:.0f} %", 100 * f.input.truth_progress)
                  : "working out the reference");
    return;
  }
  if (const std::string note = other_surface_note(*a); !note.empty())
    p.text_in(shelf.below(line_height(small)), small, theme().accent, note);
  heading(p, shelf, table, "against the reference in double precision");
  draw_lines(p, shelf, table, a->stored, -1);
  shelf.below(small * 0.4f);
  heading(p, shelf, table, "the sum, term by term");
  draw_lines(p, shelf, table, a->terms, a->first_off);
  shelf.below(small * 0.4f);
  if (a->surface)
    draw_lights(p, shelf, table, *a, shading_of(f.stored.lights.method) != Shading::forward, f.state.of<PixelState>());
}

void scroll_lights(FrameContext& f, const KeyEvent& e) {
  PixelState& s = f.state.of<PixelState>();
  const size_t by = std::max<size_t>(1, s.shown), n = f.input.account ? f.input.account->lights.size() : 0;
  if (e.key == "PgUp")
    s.first -= std::min(s.first, by);
  else if (s.first + by < n)
    s.first += by;
}

constexpr PanelKey kKeys[] = {{"PgUp PgDn", "more lights", scroll_lights, true}};

void ask(FrameContext& f) { f.requests.account = f.state.of<PixelState>().open && f.state.held_at.has_value(); }

void open_pixel(FrameContext& f, const KeyEvent&) {
  PixelState& s = f.state.of<PixelState>();
  const bool opens = !s.open;
  if (opens) close_panels(f.state, {Place::beside});
  s.open = opens;
  s.first = 0;
  if (s.open && !f.state.held_at && f.state.hovered_pixel) f.hold(*f.state.hovered_pixel);
}

}  // namespace

extern const Panel kPixelPanel = {.key = "Ctrl+P",
                                  .id = "pixel",
                                  .help = "the held pixel explained: its bits, the truth, its lights, the sum",
                                  .place = Place::beside,
                                  .box = side_box,
                                  .draw = draw_pixel,
                                  .keys = kKeys,
                                  .make = make_panel_state<PixelState>,
                                  .press = open_pixel,
                                  .update = ask};

}  // namespace gbl::ui
