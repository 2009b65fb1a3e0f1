#include <algorithm>
#include <cassert>
#include <fmt/format.h>

#include "ui/key_spec.h"
#include "ui/panel.h"
#include "ui/state.h"

namespace gbl::ui {

// From the topmost to the lowest: keys go to the first open one that knows them, and Esc closes the first.
#define GBL_PANELS(PANEL) \
  PANEL(GoTo)             \
  PANEL(Path)             \
  PANEL(Lessons)          \
  PANEL(Overlays)         \
  PANEL(Pitfalls)         \
  PANEL(Compare)          \
  PANEL(Options)          \
  PANEL(Help)             \
  PANEL(Chart)            \
  PANEL(Stability)        \
  PANEL(Advisor)          \
  PANEL(Pixel)            \
  PANEL(Outside)          \
  PANEL(Card)

#define GBL_DECLARE(name) extern const Panel k##name##Panel;
#define GBL_ADDRESS(name) &k##name##Panel,
GBL_PANELS(GBL_DECLARE)

namespace {

constexpr const Panel* kPanels[] = {GBL_PANELS(GBL_ADDRESS)};

PanelState& state_of(const State& s, const Panel& panel) {
  return *s.panels[static_cast<size_t>(std::find(std::begin(kPanels), std::end(kPanels), &panel) - kPanels)];
}

bool among(std::initializer_list<Place> places, Place place) {
  return std::find(places.begin(), places.end(), place) != places.end();
}

bool any_open(const State& s, std::initializer_list<Place> places) {
  return std::any_of(std::begin(kPanels), std::end(kPanels),
                     [&](const Panel* p) { return state_of(s, *p).open && among(places, p->place); });
}

// On screen now; else an empty one.
Box box_of(const FrameContext& f, const Panel& panel) { return state_of(f.state, panel).open ? panel.box(f) : Box{}; }

bool press_key(FrameContext& f, const Panel& panel, const KeyEvent& e) {
  for (const PanelKey& row : panel.keys) {
    const KeySpec spec = key_spec(row.key);
    const std::optional<size_t> which = row.run ? which_key(spec, e) : std::nullopt;
    if (!which) continue;
    if (!e.repeat || row.repeats) row.run(f, as_in_table(spec, *which, e));
    return true;
  }
  return panel.press_other && panel.press_other(f, e);
}

}  // namespace

std::span<const Panel* const> panels() { return kPanels; }

std::vector<std::unique_ptr<PanelState>> make_panel_states() {
  std::vector<std::unique_ptr<PanelState>> states;
  for (const Panel* p : kPanels) states.push_back(p->make());
  return states;
}

const Panel& panel(std::string_view id) {
  const auto found = std::find_if(std::begin(kPanels), std::end(kPanels), [&](const Panel* p) { return p->id == id; });
  assert(found != std::end(kPanels));
  return **found;
}

bool is_open(const State& s, std::string_view id) { return state_of(s, panel(id)).open; }
bool panel_beside(const State& s) { return any_open(s, {Place::beside}); }
bool letters_are_a_panels(const State& s) { return any_open(s, {Place::edge, Place::beside}); }

void press_panel(FrameContext& f, const Panel& panel, const KeyEvent& e) {
  if (panel.press) return panel.press(f, e);
  const bool open = !state_of(f.state, panel).open;
  if (open && among({Place::beside, Place::edge}, panel.place)) close_panels(f.state, {panel.place});
  state_of(f.state, panel).open = open;
}

bool press_in_panels(FrameContext& f, const KeyEvent& e) {
  return std::any_of(std::begin(kPanels), std::end(kPanels),
                     [&](const Panel* p) { return state_of(f.state, *p).open && press_key(f, *p, e); });
}

bool close_top_panel(State& s) {
  const auto top =
      std::find_if(std::begin(kPanels), std::end(kPanels), [&](const Panel* p) { return state_of(s, *p).open; });
  if (top == std::end(kPanels)) return false;
  state_of(s, **top).open = false;
  return true;
}

void close_panels(State& s, std::initializer_list<Place> places) {
  for (const Panel* p : kPanels)
    if (among(places, p->place)) state_of(s, *p).open = false;
}

void turn_panels(State& s, View v) {
  for (const Panel* p : kPanels)
    if (p->follow) p->follow(s, v);
}

void draw_panels(FrameContext& f) {
  for (auto p = std::rbegin(kPanels); p != std::rend(kPanels); ++p) {
    const Panel& panel = **p;
    if (panel.update) panel.update(f);
    const Box box = box_of(f, panel);
    if (box.width() <= 0) continue;
    begin_overlay(panel.id, box, panel.place == Place::over ? theme().surface : theme().background);
    Painter painter(*ImGui::GetWindowDrawList(), f.state.cut_texts);
    panel.draw(f, painter, box);
    end_overlay();
  }
}

std::string panels_in_words(const FrameContext& f) {
  std::string text;
  for (const Panel* p : kPanels)
    if (state_of(f.state, *p).open)
      text += fmt::format("{}Panel {}: {}.{}", text.empty() ? "" : "\n", p->id, p->help,
                          p->in_words ? " " + p->in_words(f) : "");
  return text;
}

bool covered(const FrameContext& f, const Box& picture) {
  return std::any_of(std::begin(kPanels), std::end(kPanels), [&](const Panel* p) {
    return p->place == Place::whole ? state_of(f.state, *p).open : box_of(f, *p).contains(picture);
  });
}

void make_room(FrameContext& f) {
  for (const Panel* p : kPanels)
    if (state_of(f.state, *p).open && among({Place::edge, Place::beside}, p->place))
      f.layout.strip.max.x = std::min(f.layout.strip.max.x, p->box(f).min.x);
}

}  // namespace gbl::ui
