#include "ui/keys.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

#include "renderer/options/options.h"
#include "ui/commands.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

// Rows with a modifier come before the same key without one.
constexpr KeyCommand kCommands[] = {
    {"0", "view.all", "all views at once", show_all},
    {"B", "preset", "next preset; Shift: the one before", next_preset},
    {"O", "options", "all options: then the letter on the screen; O again: the next page", toggle_options},
    {"Home", "home", "everything as it was loaded", go_home},
    {"I", "glide", "glide into the picked light, and back", glide},
    {"Shift , .", "light.solo", "the picked light alone; again: all", solo_light},
    {", .", "light.pick", "pick the light before or after", pick_light, true},
    {"PgUp PgDn", "lesson.step", "a lesson's step back or on; none open: choose one", step_lesson},
    {"Enter", "lesson.reveal", "show the answer", reveal_answer},
    {"Ctrl+G", "pixel.go-to", "hold the pixel at a typed x, y", open_go_to},
    {"G", "object.pick", "outline and name the object under the mouse or at the held pixel; again: none", pick_object},
    {"U", "error", "the error against the reference, alone; Shift: the reference; again: all views", show_error},
    {"J", "error.worst", "hold the pixel whose error is largest", go_to_worst},
    {"H", "card", "what is this buffer: the card of the view under the mouse, or of the chosen one", toggle_card},
    {"Space", "time.pause", "let the lights move, or stop them", toggle_time},
    {"F1", "help", "these keys", toggle_help},
    {"F2", "hide", "the pictures alone; again: everything", toggle_hidden},
    {"F3", "chart",
     "speed against accuracy: a study's set-ups as points, live. In it: R runs the study, S another, arrows and Enter "
     "choose and apply a point, X Y axes, L K logarithms, F front, G families, 1-8 show one, + - 0 zoom",
     toggle_chart},
    {"F4", "stability",
     "stability: one parameter through the place where methods break, a curve each, its statement checked. In it: S "
     "another sweep, R runs it, Up Down choose a curve, 1-8 show one, L logarithm",
     toggle_stability},
    {"F5", "shaders.reload", "read the shaders again", reload_shaders},
    {"F6", "panels", "walk the panel with Tab and the arrow keys; Esc leaves", toggle_navigation},
    {"F7", "advisor",
     "the cheapest set-up that holds an error budget. In it: [ ] and B the budget, X the cost, R looks for it, Enter "
     "applies the best, Shift+Enter the runner-up, PgUp PgDn what is left out",
     toggle_advisor},
    {"F12", "figure", "save what is on screen as a figure", save_figure},
    {"+ -", "ui.scale", "larger or smaller type", scale_type, true},
    {"W A S D Q E", "camera", "move while held, Q E down and up; Shift fast, Ctrl slow; drag the picture to look",
     nullptr},
    {"Left Right Up Down", "pixel.nudge", "move the held pixel by one; Shift: by ten", nudge_pixel, true},
    {"Esc", "close", "close what is open; then let go of the pixel, the lesson, the hidden panels", close_top},
};

std::string printed(std::string_view key) {
  std::string out(key);
  if (out == "=") return "+";  // the same key on most keyboards, without Shift
  if (out == "_") return "-";
  if (out.size() == 1) out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

struct KeySpec {
  bool shift = false, ctrl = false;
  std::vector<std::string_view> keys;
};

KeySpec parse(std::string_view spec) {
  KeySpec out;
  if (spec.starts_with("Ctrl+")) {
    out.ctrl = true;
    spec.remove_prefix(5);
  }
  while (!spec.empty()) {
    const size_t space = spec.find(' ');
    const std::string_view token = spec.substr(0, space);
    if (token == "Shift")
      out.shift = true;
    else
      out.keys.push_back(token);
    spec.remove_prefix(space == std::string_view::npos ? spec.size() : space + 1);
  }
  return out;
}

// Which of the row's keys this is, from 0; -1 = none.
int match(const char* spec_text, const KeyEvent& e) {
  const KeySpec spec = parse(spec_text);
  if (e.ctrl != spec.ctrl || (spec.shift && !e.shift)) return -1;
  const auto at = std::find(spec.keys.begin(), spec.keys.end(), printed(e.key));
  return at == spec.keys.end() ? -1 : static_cast<int>(at - spec.keys.begin());
}

// A letter's Shift goes backwards; a pair of keys has its own backwards.
int direction(const Option& o, int which, const KeyEvent& e) {
  if (parse(o.key).keys.size() == 2) return which == 0 ? -1 : 1;
  return e.shift ? -1 : 1;
}

bool press_option(FrameContext& f, const KeyEvent& e) {
  for (const Option& o : options()) {
    const int which = match(o.key, e);
    if (which < 0) continue;
    if (!e.repeat || o.kind == Kind::integer) step_option(f, o, direction(o, which, e));
    return true;
  }
  return false;
}

bool press_view(FrameContext& f, const KeyEvent& e) {
  for (const ViewRow& v : views()) {
    if (match(v.key, e) < 0) continue;
    if (!e.repeat) show_view(f, v.view);
    return true;
  }
  return false;
}

void press_command(FrameContext& f, const KeyEvent& e) {
  for (const KeyCommand& c : kCommands) {
    const int which = match(c.key, e);
    if (which < 0) continue;
    if (c.run && (!e.repeat || c.repeats)) c.run(f, {std::string(parse(c.key).keys[which]), e.shift, e.ctrl, e.repeat});
    return;
  }
}

bool belongs_to_navigation(const KeyEvent& e) {
  constexpr const char* kKeys[] = {"Left", "Right", "Up", "Down", "Space", "Enter", "Tab"};
  return std::find(std::begin(kKeys), std::end(kKeys), e.key) != std::end(kKeys);
}

// A field that is being typed into, or will be next frame, keeps every key but Esc.
bool typing(const FrameContext& f) { return f.state.go_to || f.state.edited || ImGui::GetIO().WantTextInput; }

}  // namespace

void dispatch(FrameContext& f, const KeyEvent& e) {
  const bool function_key = e.key.size() > 1 && e.key[0] == 'F';  // no field wants those
  if (typing(f) && !function_key) {
    if (e.key == "Esc") stop_typing(f);
    if (e.key == "Enter") f.state.entered = true;
    return;
  }
  f.state.notice.clear();
  f.state.dismissed = f.input.message;
  if ((ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) && belongs_to_navigation(e)) return;
  f.state.caption.reset();
  if (f.state.chooser && press_in_chooser(f, e)) return;
  if (f.state.options_page && press_in_options(f, e)) return;
  if (f.state.chart.open && press_in_chart(f, e)) return;
  if (f.state.stability.open && press_in_stability(f, e)) return;
  if (f.state.advisor.open && press_in_advisor(f, e)) return;
  if (press_option(f, e) || press_view(f, e)) return;
  press_command(f, e);
}

std::vector<KeyRow> key_rows() {
  std::vector<KeyRow> rows;
  for (const Option& o : options())
    if (*o.key)
      rows.push_back(
          {o.key, o.path,
           fmt::format("{}: {}{}", o.label, o.help, o.kind == Kind::choice ? " (Shift: back)" : " (halve, double)")});
  for (const ViewRow& v : views())
    if (*v.key)
      rows.push_back({v.key, fmt::format("view.{}", v.id), fmt::format("{} alone; again: all views", v.label)});
  for (const KeyCommand& c : kCommands) rows.push_back({c.key, c.id, c.help});
  return rows;
}

std::vector<KeyEvent> presses_of(const KeyRow& row) {
  const KeySpec spec = parse(row.key);
  std::vector<KeyEvent> presses;
  for (const std::string_view key : spec.keys) {
    std::string name(key);
    if (name.size() == 1) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    presses.push_back({name, spec.shift, spec.ctrl, false});
  }
  return presses;
}

}  // namespace gbl::ui
