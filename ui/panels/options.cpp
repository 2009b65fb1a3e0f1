// O: every option, a page at a time, each with the key or the letter that reaches it. Choices cycle; numbers and
// texts are typed, Enter applies.
#include "ui/panels/options.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include "ui/closed_sets.h"
#include "ui/key_spec.h"
#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

constexpr size_t kPageRows = 22;

struct OptionsState : PanelState {
  int page = 0;
};

struct Page {
  std::string title;
  std::vector<const Option*> options;
};

// How it is drawn comes first: that is what a lecture turns. A longer group is split evenly.
std::vector<Page> make_pages() {
  std::vector<Page> pages;
  const auto add = [&](std::string title, std::initializer_list<Group> groups) {
    std::vector<const Option*> all;
    for (const Group g : groups)
      for (const Option& o : options())
        if (o.group == g) all.push_back(&o);
    const size_t n = (all.size() + kPageRows - 1) / kPageRows;
    for (size_t i = 0; i < n; ++i)
      pages.push_back({n > 1 ? fmt::format("{} ({}/{})", title, i + 1, n) : title,
                       {all.begin() + static_cast<long>(all.size() * i / n),
                        all.begin() + static_cast<long>(all.size() * (i + 1) / n)}});
  };
  add("How it is drawn", {Group::method, Group::view});
  add("What is true", {Group::truth});
  return pages;
}

const std::vector<Page>& pages() {
  static const std::vector<Page> kPages = make_pages();  // of a constant table
  return kPages;
}

// The field shows fewer digits than are stored: the exact value stays unless the text is changed.
void apply_text(FrameContext& f, const Option& o, const std::string& text) {
  if (text != value_text(o, f.settings)) edit_option_as_typed(f, o, text);
}

void draw_field(FrameContext& f, const Option& o, const Box& box, float px) {
  const std::string text = value_text(o, f.settings);
  char buffer[256] = {};
  std::memcpy(buffer, text.data(), std::min(text.size(), sizeof buffer - 1));
  px = f.painter.fit(text, {box.width() - px, box.height()}, px, false);
  const bool entered = draw_text_field(f, o.path, box, px, buffer, sizeof buffer);
  if (entered) apply_text(f, o, buffer);
}

struct Rows {
  float px, height, key, label;
};

void draw_row(FrameContext& f, Painter& p, const Box& row, const std::vector<const Option*>& page, const Option& o,
              const Rows& z) {
  const std::string key = *o.key ? o.key : option_letter(page, o);
  const float top = row.min.y + (row.height() - line_height(z.px)) / 2;
  p.key_cap({row.min.x, top}, z.px, key);
  p.text_in({{row.min.x + z.key, top + above_text(z.px)}, {row.min.x + z.key + z.label - 4, row.max.y + z.px}}, z.px,
            theme().text, o.label);
  const Box widget{{row.min.x + z.key + z.label, row.min.y}, row.max};
  if (!closed_items(o).empty()) return draw_closed(f, o, widget, z.px);
  if (o.kind != Kind::choice) return draw_field(f, o, widget, z.px);
  const bool unsound = !sound_mark(o, f.settings).empty();
  const float sign = text_size(kUnsoundSign, z.px).x * 1.2f;
  if (unsound) {
    p.text({widget.max.x - sign, top}, z.px, theme().unsound, kUnsoundSign);
    if (hit_area(fmt::format("{}.why", o.path).c_str(), {{widget.max.x - sign, widget.min.y}, widget.max}))
      return explain_unsound(f, o);
  }
  draw_choice(f, o, {widget.min, {widget.max.x - sign, widget.max.y}}, z.px);
}

// What is unsound now, and how to use the panel.
void draw_hints(FrameContext& f, Painter& p, const Box& room) {
  std::string unsound;
  for (const Unsound& u : unsound_choices(f.settings))
    unsound += fmt::format("{}{}: {}", unsound.empty() ? "" : ", ", option(u.path).label, u.pitfall);
  if (!unsound.empty()) unsound = fmt::format("{} unsound: {}", kUnsoundSign, unsound);
  const std::string hint =
      fmt::format("A letter cycles (Shift: backwards) or opens the field; Enter applies. O: page {} of {}. Esc closes.",
                  f.state.of<OptionsState>().page + 1, option_pages());
  draw_paragraphs(p, room,
                  {{unsound.empty() ? "All choices are sound." : unsound,
                    unsound.empty() ? theme().dim : theme().unsound, f.type.small},
                   {hint, theme().dim, f.type.small}},
                  4);
}

const Page& page_now(const FrameContext& f) { return pages()[static_cast<size_t>(f.state.of<OptionsState>().page)]; }

// O again is the next page, and after the last one closes.
void turn_page(FrameContext& f, const KeyEvent& e) {
  OptionsState& s = f.state.of<OptionsState>();
  if (!s.open) close_panels(f.state, {Place::edge});
  const int next = s.open ? s.page + (e.shift ? -1 : 1) : 0;
  s.open = next >= 0 && next < option_pages();
  s.page = s.open ? next : 0;
}

// The letters of the page on screen.
bool press_letter(FrameContext& f, const KeyEvent& e) {
  const std::vector<const Option*>& page = page_now(f).options;
  for (const Option* o : page) {
    if (*o->key || !which_key(key_spec(option_letter(page, *o)), e)) continue;
    if (e.repeat) return true;
    if (o->kind == Kind::choice)
      step_option(f, *o, e.shift ? -1 : 1);
    else if (!closed_items(*o).empty())
      step_closed(f, *o, e.shift ? -1 : 1);
    else
      f.state.type_into(o->path);
    return true;
  }
  return false;
}

void draw_options(FrameContext& f, Painter& p, const Box& box) {
  const Page& page = page_now(f);
  const Box room = box.inset(std::round(12 * f.layout.unit));
  const float head = line_height(f.type.large), hints = 5 * line_height(f.type.small);
  p.text_in({room.min, {room.max.x, room.min.y + head}}, f.type.large, theme().accent, page.title);
  const float row = std::min(f.type.body * 2, (room.height() - head - hints) / static_cast<float>(page.options.size()));
  const float px = std::max(kSmallestPx, std::floor(std::min(f.type.body, row * 0.62f)));
  const Rows z{px, row, 2 * key_cap_width("[ ]", px) - px, room.width() * 0.36f};
  float y = room.min.y + head;
  for (const Option* o : page.options) {
    draw_row(f, p, {{room.min.x, std::round(y)}, {room.max.x, std::round(y + row) - 3}}, page.options, *o, z);
    y += row;
  }
  draw_hints(f, p, {{room.min.x, room.max.y - hints}, room.max});
}

}  // namespace

int option_pages() { return static_cast<int>(pages().size()); }
std::vector<const Option*> options_on_page(int page) { return pages()[static_cast<size_t>(page)].options; }

std::string option_letter(const std::vector<const Option*>& page, const Option& wanted) {
  std::string taken = "O";
  for (const Option* o : page) taken += o->key;
  char letter = 'A' - 1;
  for (const Option* o : page) {
    if (*o->key) continue;
    do ++letter;
    while (taken.find(letter) != std::string::npos);
    if (o == &wanted && letter <= 'Z') return {letter};
  }
  return "";
}

extern const Panel kOptionsPanel = {.key = "O",
                                    .id = "options",
                                    .help = "all options: then the letter on the screen; O again: the next page",
                                    .place = Place::edge,
                                    .box = edge_box,
                                    .draw = draw_options,
                                    .make = make_panel_state<OptionsState>,
                                    .press = turn_page,
                                    .press_other = press_letter};

}  // namespace gbl::ui
