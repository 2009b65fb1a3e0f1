// P: where methods fail. A list by groups, and the entry that is open: a question first, then what is seen and why, with
// the number broken and fixed. X goes round broken, fixed, reference, difference; leaving brings back what was there.
#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/frame/validate.h"
#include "renderer/study/pitfalls/watch.h"
#include "ui/panels/pitfalls_view.h"

namespace gbl::ui {
namespace {

constexpr double kPathSeconds = 8;
constexpr const char* kFindField = "pitfalls.find";

PitfallsState& state_of(const FrameContext& f) { return f.state.of<PitfallsState>(); }

// ---- what is shown -------------------------------------------------------------------------------------------------

PitfallSide side_of(Shown s) {
  return s == Shown::fixed ? PitfallSide::fixed : s == Shown::hidden ? PitfallSide::blind : PitfallSide::broken;
}

Settings settings_shown(const PitfallEntry& e, Shown shown) {
  if (shown != Shown::reference) return settings_of(e, side_of(shown));
  Settings s = truth_of(e, PitfallSide::broken);  // what judges it, where the model is what fails
  s.view.main = "reference";
  return s;
}

// The camera stays where it was moved to while the entry is open, but for the one that hides it.
void show(State& state, Settings& settings, Shown shown, bool keep_camera) {
  OpenPitfall& o = *state.of<PitfallsState>().opened;
  const Settings now = settings;
  o.shown = shown;
  settings = settings_shown(o.entry, shown);
  settings.size = now.size;
  if (keep_camera)
    settings.camera = now.camera, settings.time_s = now.time_s;
  else
    o.along.reset(), state.on_path = false;
  state.comparison = {};
  state.comparison.other = settings_of(o.entry, shown == Shown::fixed ? PitfallSide::broken : PitfallSide::fixed);
  state.comparison.other->camera = settings.camera;
  if (shown == Shown::difference) state.comparison.mode = CompareMode::difference;
  state.large = true;
  state.glide.reset(), state.before_glide.reset();
  state.caption.reset();
  state.history.pass_over(settings);  // leaving brings back what was there
}

// A device without a feature cannot draw some: that is said, and what is shown stays.
bool can_show(FrameContext& f, const PitfallEntry& e, Shown shown) {
  try {
    require_valid(settings_shown(e, shown), {f.input.features});
    return true;
  } catch (const Error& error) {
    f.state.notice = error.what();
    return false;
  }
}

void open(State& state, Settings& settings, PitfallEntry entry) {
  PitfallsState& s = state.of<PitfallsState>();
  if (!s.before) s.before = {settings, state.large, state.comparison};
  s.opened = OpenPitfall{std::move(entry)};
  show(state, settings, Shown::broken, false);
}

void leave(FrameContext& f) {
  PitfallsState& s = state_of(f);
  if (s.before) {
    replace_settings(f, s.before->settings);
    f.state.large = s.before->large, f.state.comparison = s.before->comparison;
    f.state.history.pass_over(f.settings);
  }
  s.before.reset(), s.opened.reset();
}

// ---- the list ------------------------------------------------------------------------------------------------------

// The one that the picture shows now, or that a choice is unsound by.
size_t index_of_shown(const PitfallsState& s, const FrameContext& f) {
  std::vector<std::string> wanted;
  const double aspect = double(f.settings.size.x) / f.settings.size.y;
  if (const std::optional<Watched> w = watched(f.settings, f.input.lights, aspect)) wanted.push_back(w->pitfall);
  for (const Unsound& u : unsound_choices(f.settings)) wanted.push_back(u.pitfall);
  for (const std::string& id : wanted)
    for (size_t i = 0; i < s.entries.size(); ++i)
      if (s.entries[i].id == id) return i;
  return 0;
}

void load(State& state) {
  PitfallsState& s = state.of<PitfallsState>();
  if (s.entries.empty()) s.entries = load_pitfalls();
}

void press_list(FrameContext& f, const KeyEvent&) {
  PitfallsState& s = state_of(f);
  if (s.open) {
    s.open = false;
    return;
  }
  try {
    load(f.state);
  } catch (const Error& e) {
    f.state.notice = e.what();
    return;
  }
  close_panels(f.state, {Place::edge, Place::beside});
  s.chosen = index_of_shown(s, f);
  s.open = true;
}

void move_choice(FrameContext& f, const KeyEvent& e) {
  PitfallsState& s = state_of(f);
  const std::vector<size_t> found = found_entries(s);
  if (found.empty()) return;
  const auto at = std::find(found.begin(), found.end(), s.chosen);
  const auto i = at - found.begin(), last = static_cast<std::ptrdiff_t>(found.size()) - 1;
  const auto next =
      at == found.end() ? 0 : std::clamp<std::ptrdiff_t>(i + (e.key == "Up" || e.key == "PgUp" ? -1 : 1), 0, last);
  s.chosen = found[static_cast<size_t>(next)];
  if (s.opened && can_show(f, s.entries[s.chosen], Shown::broken)) open(f.state, f.settings, s.entries[s.chosen]);
}

void enter(FrameContext& f, const KeyEvent&) {
  PitfallsState& s = state_of(f);
  if (s.opened)
    s.opened->revealed = !s.opened->revealed;
  else if (const std::vector<size_t> found = found_entries(s);
           std::find(found.begin(), found.end(), s.chosen) != found.end() &&
           can_show(f, s.entries[s.chosen], Shown::broken))
    open(f.state, f.settings, s.entries[s.chosen]);
}

void next_shown(FrameContext& f, const KeyEvent& e) {
  PitfallsState& s = state_of(f);
  if (!s.opened) return say(f, {"Enter opens the pitfall first.", ""});
  const bool hidden = s.opened->shown == Shown::hidden;
  const int now = hidden ? 3 : static_cast<int>(s.opened->shown);
  const auto next = static_cast<Shown>((now + (e.shift ? 3 : 1)) % 4);
  if (can_show(f, s.opened->entry, next)) show(f.state, f.settings, next, !hidden);
}

void show_hidden(FrameContext& f, const KeyEvent&) {
  PitfallsState& s = state_of(f);
  if (!s.opened || !s.opened->entry.blind) return say(f, {"No place is known where this one hides.", ""});
  show(f.state, f.settings, s.opened->shown == Shown::hidden ? Shown::broken : Shown::hidden, false);
}

void to_list(FrameContext& f, const KeyEvent&) { leave(f); }
void find(FrameContext& f, const KeyEvent&) {
  leave(f);
  f.state.type_into(kFindField);
}

void put_on_path(FrameContext& f, double along) {
  OpenPitfall& o = *state_of(f).opened;
  o.along = std::clamp(along, 0.0, 1.0);
  f.settings.camera = camera_on_path(o.entry, *o.along);
  if (f.state.comparison.other) f.state.comparison.other->camera = f.settings.camera;
  f.state.history.pass_over(f.settings);
}

bool has_path(FrameContext& f) {
  const PitfallsState& s = state_of(f);
  if (s.opened && s.opened->entry.path) return true;
  say(f, {s.opened ? "This one has no path." : "Enter opens the pitfall first.", ""});
  return false;
}

void play_path(FrameContext& f, const KeyEvent&) {
  if (!has_path(f)) return;
  f.state.on_path = !f.state.on_path;
  const double along = state_of(f).opened->along.value_or(1);
  if (f.state.on_path && along >= 1) put_on_path(f, 0);
}

void step_path(FrameContext& f, const KeyEvent& e) {
  if (!has_path(f)) return;
  f.state.on_path = false;
  put_on_path(f, state_of(f).opened->along.value_or(0) + (e.key == "Left" ? -1 : 1) / (2.0 * (kPathPoints - 1)));
}

void advance_path(FrameContext& f) {
  PitfallsState& s = state_of(f);
  const double passed = std::min(f.input.seconds - std::exchange(s.last_seconds, f.input.seconds), 0.5);
  if (!f.state.on_path || !s.opened || !s.opened->along) {
    f.state.on_path = false;
    return;
  }
  put_on_path(f, *s.opened->along + passed / kPathSeconds);
  f.state.on_path = *s.opened->along < 1;
}

constexpr PanelKey kKeys[] = {
    {"X", "broken, fixed, reference, difference", next_shown, true},
    {"Enter", "open it; then the answer", enter},
    {"Up Down", "choose", move_choice, true},
    {"PgUp PgDn", "the one before, the next", move_choice, true},
    {"Space", "along its path", play_path},
    {"Left Right", "by hand", step_path, true},
    {"W", "where it hides", show_hidden},
    {"L", "back to the list", to_list},
    {"F", "find", find},
    {"P", "close, as it was", nullptr},
};

void draw_pitfalls(FrameContext& f, Painter& p, const Box& box) {
  PitfallsState& s = state_of(f);
  Shelf shelf{box.inset(std::round(12 * f.layout.unit)), std::round(8 * f.layout.unit)};
  const Box keys = shelf.above(6 * line_height(f.type.small));
  if (s.opened) {
    if (s.opened->entry.path && s.opened->revealed)
      draw_pitfall_path(f, *s.opened, p, shelf.above(6 * line_height(f.type.small)));
    draw_pitfall_entry(f, *s.opened, p, shelf.room);
  } else {
    p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent, "Where methods fail");
    const Box field = shelf.below(line_height(f.type.body) * 1.3f);
    if (draw_text_field(f, kFindField, field, f.type.body, s.find, sizeof s.find)) {
      const std::vector<size_t> found = found_entries(s);
      if (!found.empty()) s.chosen = found.front();
    }
    const std::optional<size_t> clicked = draw_pitfall_list(f, s, p, shelf.room);
    if (clicked && can_show(f, s.entries[*clicked], Shown::broken)) {
      s.chosen = *clicked;
      open(f.state, f.settings, s.entries[*clicked]);
    }
  }
  draw_panel_keys(f, p, keys, kKeys);
}

void update(FrameContext& f) {
  PitfallsState& s = state_of(f);
  if (!s.open && s.before) leave(f);
  advance_path(f);
  if (s.open && s.opened) f.requests.pitfall.id = s.opened->entry.id;
  f.requests.pitfall.list = s.open && !s.opened;
}

}  // namespace

void open_pitfall(State& state, Settings& settings, std::string_view id) {
  const PitfallEntry entry = load_pitfall(id);
  load(state);
  PitfallsState& s = state.of<PitfallsState>();
  for (size_t i = 0; i < s.entries.size(); ++i)
    if (s.entries[i].id == id) s.chosen = i;
  close_panels(state, {Place::edge, Place::beside});
  s.open = true;
  open(state, settings, entry);
}

void explain_unsound(FrameContext& f, const Option& o) {
  try {
    open_pitfall(f.state, f.settings, id_of(o.values[static_cast<size_t>(chosen(o, f.settings))].pitfall));
  } catch (const Error& e) {
    f.state.notice = e.what();
  }
}

extern const Panel kPitfallsPanel = {.key = "P",
                                     .id = "pitfalls",
                                     .help = "where methods fail: each failure with its cause, its fix and its number",
                                     .place = Place::edge,
                                     .box = edge_box,
                                     .draw = draw_pitfalls,
                                     .keys = kKeys,
                                     .make = make_panel_state<PitfallsState>,
                                     .press = press_list,
                                     .update = update};

}  // namespace gbl::ui
