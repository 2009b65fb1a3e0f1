// P: where methods fail. A list by groups, and the entry that is open: a question first, then what is seen and why, with
// the number broken and fixed. X goes round broken, fixed, reference, difference; leaving brings back what was there.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/frame/validate.h"
#include "renderer/study/pitfalls/watch.h"
#include "ui/panels/side_panel.h"

namespace gbl::ui {
namespace {

enum class Shown { broken, fixed, reference, difference, hidden };
constexpr const char* kShown[] = {"BROKEN", "FIXED", "the REFERENCE of the broken one",
                                  "broken and fixed: the DIFFERENCE", "broken, WHERE IT HIDES"};

struct OpenPitfall {
  PitfallEntry entry;
  Shown shown = Shown::broken;
  bool revealed = false;
  std::optional<double> along;  // where the camera is on the path; empty: nowhere on it
};

struct PitfallsState : PanelState {
  std::vector<PitfallEntry> entries;
  size_t chosen = 0;
  char find[64] = {};
  std::optional<OpenPitfall> opened;
  struct Before {
    Settings settings;
    bool large;
    Comparison comparison;
  };
  std::optional<Before> before;  // the first entry was opened
  double last_seconds = 0;
};

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

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<size_t> found_entries(const PitfallsState& s) {
  std::vector<size_t> out;
  const std::string wanted = lower(s.find);
  for (size_t i = 0; i < s.entries.size(); ++i) {
    const PitfallEntry& e = s.entries[i];
    if (lower(e.id + " " + e.title + " " + e.symptom + " " + e.source).find(wanted) != std::string::npos)
      out.push_back(i);
  }
  return out;
}

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

void draw_list(FrameContext& f, Painter& p, const Box& room) {
  PitfallsState& s = state_of(f);
  const float px = f.type.small, row = std::round(line_height(px) * 1.15f);
  const std::vector<size_t> found = found_entries(s);
  // Lines: a group's name, then its entries.
  struct Line {
    std::string heading;
    size_t entry = 0;
  };
  std::vector<Line> lines;
  size_t at_chosen = 0;
  for (const PitfallGroup& g : pitfall_groups()) {
    bool any = false;
    for (const size_t i : found) {
      if (s.entries[i].group != g.id) continue;
      if (!any) lines.push_back({g.label, 0});
      any = true;
      if (i == s.chosen) at_chosen = lines.size();
      lines.push_back({"", i});
    }
  }
  if (lines.empty()) return draw_paragraphs(p, room, {{"Nothing is found.", theme().dim, px}}, 2);
  const auto fit = static_cast<size_t>(std::max(1.0f, room.height() / row));
  const size_t first = lines.size() <= fit ? 0 : std::min(at_chosen - std::min(at_chosen, fit / 2), lines.size() - fit);
  float y = room.min.y;
  for (size_t i = first; i < std::min(lines.size(), first + fit); ++i, y += row) {
    const Box line{{room.min.x, y}, {room.max.x, y + row - 1}};
    if (!lines[i].heading.empty()) {
      p.text_in({{line.min.x, line.min.y + above_text(px)}, {line.max.x, line.max.y + px}}, px, theme().accent,
                lines[i].heading);
      continue;
    }
    const PitfallEntry& e = s.entries[lines[i].entry];
    if (hit_area(e.id.c_str(), line) && can_show(f, e, Shown::broken)) {
      s.chosen = lines[i].entry;
      open(f.state, f.settings, e);
    }
    if (lines[i].entry == s.chosen) p.outline(line, theme().accent, 2);
    const std::string lecture = e.lecture > 0 ? fmt::format("{} ", e.lecture) : "";
    p.text_in({{line.min.x + px, line.min.y + above_text(px)}, {line.max.x - 4, line.max.y + px}}, px, theme().text,
              lecture + e.title);
  }
}

std::string numbers_of(const FrameContext& f, const PitfallEntry& e) {
  const PitfallMetric& m = pitfall_metric(e.metric);
  const PitfallInput* in = f.input.pitfall;
  if (!in || in->id != e.id) return m.help;
  const auto text = [&](std::optional<double> n) { return n ? number_text(n) : in->running ? "…" : "none"; };
  std::string out = fmt::format("{} broken, {} fixed", text(in->broken), text(in->fixed));
  if (e.blind) out += fmt::format(", {} where it hides", text(in->blind));
  return fmt::format("{}: {}{}", out, m.help, *m.unit ? fmt::format(" ({})", m.unit) : "");
}

void draw_entry(FrameContext& f, Painter& p, const Box& room) {
  const OpenPitfall& o = *state_of(f).opened;
  const PitfallEntry& e = o.entry;
  const float px = std::round(f.type.body * 1.3f);  // shrinks until all of it fits
  const ImU32 shown = o.shown == Shown::fixed ? theme().accent : theme().unsound;
  std::vector<Paragraph> words = {{e.title, theme().accent, px * 1.2f}, {kShown[static_cast<int>(o.shown)], shown, px}};
  if (!o.revealed) {
    words.push_back({e.question, theme().text, px * 1.2f});
    words.push_back({"Enter shows the answer.", theme().dim, f.type.body});
    return draw_paragraphs(p, room, words, px * 0.6f);
  }
  words.push_back({e.symptom, theme().text, px});
  words.push_back({numbers_of(f, e), theme().accent, px});
  if (f.input.pitfall && f.input.pitfall->id == e.id && !f.input.pitfall->note.empty())
    words.push_back({f.input.pitfall->note, theme().unsound, px});
  words.push_back({"Why: " + e.cause, theme().text, px});
  words.push_back({"Do: " + e.do_this, theme().text, px});
  words.push_back({"Don't: " + e.do_not, theme().text, px});
  words.push_back({"Impact: " + e.impact, theme().text, px});
  words.push_back({"How to see it: " + e.see, theme().text, px});
  words.push_back({"What is left: " + e.still, theme().text, px});
  if (e.blind) words.push_back({"Where it hides: " + e.blind->why, theme().text, px});
  words.push_back({fmt::format("{}\n{}", e.id, e.source), theme().dim, f.type.body});
  draw_paragraphs(p, room, words, px * 0.4f);
}

// The number along the path, broken and fixed, and where the camera is.
void draw_path(FrameContext& f, Painter& p, const Box& box) {
  const OpenPitfall& o = *state_of(f).opened;
  const PitfallInput* in = f.input.pitfall;
  const float px = f.type.small, line = line_height(px);
  p.text_in({box.min, {box.max.x, box.min.y + line}}, px, theme().dim, "the number along its path: broken, and fixed");
  const Box room{{box.min.x, box.min.y + line + 4}, box.max};
  p.fill(room, theme().surface);
  if (!in || in->id != o.entry.id) return;
  double most = 0;
  for (const auto* curve : {&in->path_broken, &in->path_fixed})
    for (const double n : *curve) most = std::max(most, std::isfinite(n) ? n : 0);
  const auto place = [&](size_t i, double n) {
    const double up = most > 0 && std::isfinite(n) ? n / most : n > 0;
    return ImVec2{room.min.x + room.width() * static_cast<float>(i) / (kPathPoints - 1),
                  room.max.y - 3 - static_cast<float>(up) * (room.height() - 6)};
  };
  for (const auto& [curve, colour] :
       {std::pair(&in->path_fixed, theme().accent), {&in->path_broken, theme().unsound}}) {
    std::vector<ImVec2> places;
    for (size_t i = 0; i < curve->size(); ++i) places.push_back(place(i, (*curve)[i]));
    p.list().AddPolyline(places.data(), static_cast<int>(places.size()), colour, 0, 2);
  }
  if (!o.along) return;
  const float x = room.min.x + room.width() * static_cast<float>(*o.along);
  p.list().AddLine({x, room.min.y}, {x, room.max.y}, theme().text, 2);
}

void draw_pitfalls(FrameContext& f, Painter& p, const Box& box) {
  PitfallsState& s = state_of(f);
  Shelf shelf{box.inset(std::round(12 * f.layout.unit)), std::round(8 * f.layout.unit)};
  const Box keys = shelf.above(6 * line_height(f.type.small));
  if (s.opened) {
    if (s.opened->entry.path && s.opened->revealed) draw_path(f, p, shelf.above(6 * line_height(f.type.small)));
    draw_entry(f, p, shelf.room);
  } else {
    p.text_in(shelf.below(line_height(f.type.large)), f.type.large, theme().accent, "Where methods fail");
    const Box field = shelf.below(line_height(f.type.body) * 1.3f);
    if (draw_text_field(f, kFindField, field, f.type.body, s.find, sizeof s.find)) {
      const std::vector<size_t> found = found_entries(s);
      if (!found.empty()) s.chosen = found.front();
    }
    draw_list(f, p, shelf.room);
  }
  draw_panel_keys(f, p, keys, kKeys);
}

void update(FrameContext& f) {
  PitfallsState& s = state_of(f);
  if (!s.open && s.before) leave(f);
  advance_path(f);
  if (s.open && s.opened) f.requests.pitfall.id = s.opened->entry.id;
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
