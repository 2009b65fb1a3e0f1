// Ctrl+P: the held pixel, in pages: what is stored of it, what that means beside the truth, the lights that reach it and the
// sum written out with the first term that goes wrong; its bits field by field; its position by each way to store it.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/inspect/stored_bits.h"
#include "ui/panels/pixel_parts.h"

namespace gbl::ui {
namespace {

constexpr float kUsualLines = 36;  // of a whole account

enum class Page { sum, bits, positions };
constexpr const char* kPages[] = {"the sum", "the bits", "the positions"};

struct PixelState : PanelState {
  Page page = Page::sum;
  Scroll scroll;
};

// The fields of an attachment in a line.
std::string fields_in(const Settings& drawn, const StoredTexel& t) {
  std::string text;
  for (const FieldRead& r : read_fields(drawn, t))
    if (r.field.name != kUnusedBits) text += (text.empty() ? "" : ", ") + r.field.name;
  return text;
}

void draw_stored(Painter& p, Shelf& shelf, float px, const Settings& drawn, const PixelProbe& probe) {
  heading(p, shelf, px, "stored, hexadecimal");
  Table table(p, shelf, px, {0.24f, 0.1f, 0.28f, 0.38f});
  for (const StoredTexel& t : probe.stored)
    table.row({{t.attachment.name, theme().text},
               {row(t.attachment.format).label, theme().dim},
               {hex(t), theme().text},
               {fields_in(drawn, t), theme().dim}});
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

void draw_lights(Painter& p, Shelf& shelf, float px, const PixelAccount& a, bool in_pixels, Scroll& scroll) {
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
  scroll.all = a.lights.size();
  scroll.first = std::min(scroll.first, a.lights.size() - 1);
  scroll.shown = 0;
  // Forward shading shades surfaces, hidden ones too: no count of it says more.
  for (size_t i = scroll.first; i < a.lights.size(); ++i) {
    const LightShare& l = a.lights[i];
    const std::string wrong = verdict_of(l);
    const std::string shaded = !l.shaded       ? (i < kCountedLights && in_pixels ? "…" : "not counted")
                               : wrong.empty() ? fmt::format("{}", *l.shaded)
                                               : fmt::format("{} {} {}", *l.shaded, kUnsoundSign, wrong);
    if (!table.row({{fmt::format("{}", l.index), theme().text},
                    {l.distance < kEndless ? fmt::format("{:.5g}", l.distance) : "-", theme().text},
                    {l.range < kEndless ? fmt::format("{:.3f}", l.distance / l.range) : "-", theme().text},
                    {l.hidden ? "hidden" : fmt::format("{:.3g}", l.arriving), theme().text},
                    {fmt::format("{:.3f}", l.n_dot_l), theme().text},
                    {fmt::format("{:.1f} %", 100 * l.share), theme().text},
                    {shaded, wrong.empty() ? theme().text : theme().unsound}}))
      break;
    ++scroll.shown;
  }
}

void draw_sum(FrameContext& f, Painter& p, Shelf& shelf, float px, const PixelAccount& a) {
  heading(p, shelf, px, "against the reference in double precision");
  draw_lines(p, shelf, px, a.stored, -1);
  shelf.below(px * 0.4f);
  heading(p, shelf, px, "the sum, term by term");
  draw_lines(p, shelf, px, a.terms, a.first_off);
  shelf.below(px * 0.4f);
  const bool in_pixels = shading_of(f.stored.lights.method) != Shading::forward;
  if (a.surface) draw_lights(p, shelf, px, a, in_pixels, f.state.of<PixelState>().scroll);
}

void show_page(PixelState& s, Page page) {
  s.page = page;
  s.scroll = {};
}

// The pages beside each other, each a button.
void draw_tabs(FrameContext& f, Painter& p, const Box& line, float px) {
  PixelState& s = f.state.of<PixelState>();
  const float cap = p.key_cap(line.min, px, "P");
  float x = line.min.x + cap + px;
  for (size_t i = 0; i < std::size(kPages); ++i) {
    const auto page = static_cast<Page>(i);
    const float width = text_size(kPages[i], px).x;
    const Box tab{{x, line.min.y}, {x + width, line.max.y}};
    if (hit_area(kPages[i], tab)) show_page(s, page);
    p.text({x, line.min.y + above_text(px)}, px, s.page == page ? theme().accent : theme().dim, kPages[i]);
    if (s.page == page) p.fill({{x, tab.max.y - 2}, {x + width, tab.max.y}}, theme().accent);
    x += width + px;
  }
}

// What is held, and at the right the loupe.
void draw_head(FrameContext& f, Painter& p, Shelf& shelf, const PixelProbe& probe) {
  const float side = std::min(loupe_side(f), shelf.room.width() * 0.4f), small = f.type.small;
  const Box all = shelf.below(side);
  draw_loupe(f, p, {{all.max.x - side, all.min.y}, all.max});
  Shelf left{{all.min, {all.max.x - side - small, all.max.y}}, shelf.gap};
  const std::string_view name = object_name(probe, f.input.scene);
  p.text_in(left.below(line_height(f.type.large)), f.type.large, theme().accent,
            fmt::format("pixel {}, {}   {}", probe.pixel.x, probe.pixel.y,
                        !name.empty()     ? name
                        : probe.surface() ? "a surface"
                                          : "the background"));
  p.text_in(left.below(line_height(f.type.body)), f.type.body, theme().text, loupe_numbers(f));
  draw_tabs(f, p, left.above(line_height(f.type.body)), f.type.body);
}

// What needs the reference; before it is there, how far it has come.
void draw_account(FrameContext& f, Painter& p, Shelf& shelf, float px, glm::ivec2 pixel) {
  const PixelAccount* a = f.input.account;
  if (!a || a->pixel != pixel) {
    p.text_in(shelf.below(line_height(f.type.body)), f.type.body, theme().accent,
              f.input.truth_progress < 1
                  ? fmt::format("working out the reference: {:.0f} %", 100 * f.input.truth_progress)
                  : "working out the reference");
    return;
  }
  if (const std::string note = other_surface_note(*a); !note.empty())
    p.text_in(shelf.below(line_height(f.type.small)), f.type.small, theme().accent, note);
  if (f.state.of<PixelState>().page == Page::positions)
    draw_positions(p, shelf, px, *a);
  else
    draw_sum(f, p, shelf, px, *a);
}

void draw_pixel(FrameContext& f, Painter& p, const Box& box) {
  Shelf shelf{box.inset(std::round(14 * f.layout.unit)), std::round(2 * f.layout.unit)};
  const float px = f.type.body, small = f.type.small;
  const float table = shelf.room.height() > kUsualLines * line_height(px) ? px : small;
  p.text_in(
      shelf.above(line_height(small)), small, theme().dim,
      "Ctrl+P or Esc closes   P next page   arrows move the pixel   PgUp PgDn: more lines   Ctrl+G goes to a pixel");
  const std::optional<PixelProbe>& probe = f.input.probe;
  if (!probe || !f.state.held_at) {
    p.text_in(shelf.below(3 * line_height(px)), px, theme().text,
              "Click on a picture: the pixel is held and explained here.", true);
    return;
  }
  draw_head(f, p, shelf, *probe);
  shelf.below(small * 0.4f);
  PixelState& s = f.state.of<PixelState>();
  if (s.page == Page::bits) return draw_bits(f, p, shelf, table, *probe, s.scroll);
  if (s.page == Page::sum) draw_stored(p, shelf, table, f.stored, *probe);
  draw_account(f, p, shelf, table, probe->pixel);
}

void scroll_lines(FrameContext& f, const KeyEvent& e) {
  Scroll& s = f.state.of<PixelState>().scroll;
  const size_t by = std::max<size_t>(1, s.shown);
  if (e.key == "PgUp")
    s.first -= std::min(s.first, by);
  else if (s.first + by < s.all)
    s.first += by;
}

void turn_page(FrameContext& f, const KeyEvent& e) {
  PixelState& s = f.state.of<PixelState>();
  const size_t n = std::size(kPages), step = e.shift ? n - 1 : 1;
  show_page(s, static_cast<Page>((static_cast<size_t>(s.page) + step) % n));
}

constexpr PanelKey kKeys[] = {{"P", "next page: the sum, the bits, the positions", turn_page},
                              {"PgUp PgDn", "more lines", scroll_lines, true}};

void ask(FrameContext& f) { f.requests.account = f.state.of<PixelState>().open && f.state.held_at.has_value(); }

void open_pixel(FrameContext& f, const KeyEvent&) {
  PixelState& s = f.state.of<PixelState>();
  const bool opens = !s.open;
  if (opens) close_panels(f.state, {Place::beside});
  s.open = opens;
  s.scroll = {};
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
