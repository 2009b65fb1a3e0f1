#include "ui/keys.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

#include "renderer/options/options.h"
#include "ui/commands.h"
#include "ui/compare.h"
#include "ui/figure.h"
#include "ui/key_spec.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

// Rows with a modifier come before the same key without one.
constexpr KeyCommand kCommands[] = {
    {"Ctrl+Z", "undo", "take the last change of the settings back", undo, true},
    {"Ctrl+Y", "redo", "make it again", redo, true},
    {"Tab", "compare.flip", "A or B: two whole settings; at first the state before the last change", flip},
    {"/", "compare.mode", "A and B on one picture: wipe, side by side, difference, off", next_mode},
    {"X", "cure", "sound choices in the place of the unsound ones; again: back to what fails", flip_to_cure},
    // Not Q: with Ctrl it moves the camera slowly.
    {"Ctrl+X", "quit", "close the window; the next one goes on from here", quit},
    {"Ctrl+Shift 1-9", "bookmark.keep", "keep what is shown in this bookmark", keep_bookmark},
    {"Ctrl+1-9", "bookmark.go", "go to what this bookmark keeps; an empty one keeps what is shown", go_to_bookmark},
    {"Ctrl+0", "zoom.pixels", "pixel for pixel, or where that is so already eight times as large", show_pixels},
    {"Ctrl+F", "zoom.whole", "the whole picture in all panels", show_whole_picture},
    {"Ctrl+L", "look.channels", "the large view: all channels, red, green, blue", step_channels},
    {"Ctrl+M", "look.map", "the large view: the next colour map", step_map},
    {"Ctrl+R", "look.fit", "the large view: black and white at the ends of what is seen; again: its own", fit_range},
    {"Ctrl+K", "panel.lock", "lock the large view as it looks now into the last panel; again: no locked one",
     lock_view},
    {"Ctrl+U", "look.raw", "the large view: the stored codes, undecoded; again: as the view shows itself", show_codes},
    {"Ctrl+H", "look.histogram", "the large view: its histogram, with handles for black and white", toggle_histogram},
    {"0", "view.all", "all views at once; again: the next page of them", show_all},
    {"B", "preset", "next preset; Shift: the one before", next_preset},
    {"Home", "home", "everything as it was loaded", go_home},
    {"I", "glide", "glide into the picked light, and back", glide},
    {"Shift , .", "light.solo", "the picked light alone; again: all", solo_light},
    {", .", "light.pick", "pick the light before or after", pick_light, true},
    {"Enter", "lesson.reveal", "show the answer", reveal_answer},
    {"G", "object.pick", "outline and name the object under the mouse or at the held pixel; again: none", pick_object},
    {"U", "error", "the error against the reference, alone; Shift: the reference; again: all views", show_error},
    {"J", "error.worst", "hold the pixel whose error is largest", go_to_worst},
    {"Space", "time.pause", "let the lights move, or stop them", toggle_time},
    {"Ctrl+Shift P", "present", "present: the picture fills the window, one caption in large type; again: everything",
     toggle_presenting},
    {"F2", "hide", "the pictures alone; again: everything", toggle_hidden},
    {"F5", "shaders.reload", "read the shaders again", reload_shaders},
    {"F6", "panels", "walk the panel with Tab and the arrow keys; Esc leaves", toggle_navigation},
    {"F8", "exposure.meter", "meter the exposure from what the lights do on the surfaces that are seen", meter_light},
    {"F9", "reticle", "a ring follows the mouse on the pictures, for a talk; again: none", toggle_reticle},
    {"F10", "timer", "the time since this key, with the lesson's steps; again: none", toggle_talk_timer},
    {"Shift F12", "figure.window", "save the whole window", save_window},
    {"Ctrl+T", "theme", "light colours or dark ones; figures then stand on white or on dark", toggle_theme},
    {"Ctrl+F12", "figure.white", "captions of figures on white, or on dark again", toggle_white_figures},
    {"F12", "figure", "save the chosen panel exactly as shown, with a caption", save_panel},
    {"Ctrl+Shift C", "copy.command", "the command line that draws this picture, onto the clipboard", copy_command},
    {"Ctrl+C", "copy.values", "the pixel's values, onto the clipboard", copy_values},
    {"F11", "full-screen", "fill the screen; again: a window", toggle_full_screen},
    {"+ -", "ui.scale", "larger or smaller type", scale_type, true},
    {"W A S D Q E", "camera", "move while held, Q E down and up; Shift fast, Ctrl slow; drag the picture to look",
     nullptr},
    {"Left Right Up Down", "pixel.nudge", "move the held pixel by one; Shift: by ten", nudge_pixel, true},
    {"Esc", "close", "close what is open; then let go of the pixel, the lesson, the hidden panels", close_top},
};

// A letter's Shift goes backwards; a pair of keys has its own backwards.
int direction(const KeySpec& keys, size_t which, const KeyEvent& e) {
  if (keys.keys.size() == 2) return which == 0 ? -1 : 1;
  return e.shift ? -1 : 1;
}

bool press_option(FrameContext& f, const KeyEvent& e) {
  for (const Option& o : options()) {
    const KeySpec keys = key_spec(o.key);
    const std::optional<size_t> which = which_key(keys, e);
    if (!which) continue;
    if (!e.repeat || o.kind == Kind::integer) step_option(f, o, direction(keys, *which, e));
    return true;
  }
  return false;
}

bool press_view(FrameContext& f, const KeyEvent& e) {
  for (const ViewRow& v : views()) {
    const KeySpec keys = key_spec(v.key);
    if (keys.shift != e.shift || !which_key(keys, e)) continue;
    if (!e.repeat) show_view(f, v.view);
    return true;
  }
  return false;
}

bool press_panel_key(FrameContext& f, const KeyEvent& e) {
  for (const Panel* p : panels()) {
    const KeySpec keys = key_spec(p->key);
    const std::optional<size_t> which = which_key(keys, e);
    if (!which) continue;
    if (!e.repeat) press_panel(f, *p, as_in_table(keys, *which, e));
    return true;
  }
  return false;
}

// Those that name both modifiers are looked up first: Shift is free in the other tables.
bool press_command(FrameContext& f, const KeyEvent& e, bool with_both) {
  for (const KeyCommand& c : kCommands) {
    const KeySpec keys = key_spec(c.key);
    const std::optional<size_t> which = which_key(keys, e);
    if (!which || (with_both && !(keys.shift && keys.ctrl))) continue;
    if (c.run && (!e.repeat || c.repeats)) c.run(f, as_in_table(keys, *which, e));
    return true;
  }
  return false;
}

// What is said of a panel in F1's list: its own keys stand behind its help.
std::string help_of(const Panel& p) {
  std::string text = p.help, before = ". In it: ";
  for (const PanelKey& k : p.keys) {
    if (!k.run) continue;
    text += fmt::format("{}{} {}", before, printed_keys(k.key), k.words);
    before = ", ";
  }
  return text;
}

// 0: none of F1 … F12.
int function_key(std::string_view key) { return key.size() > 1 && key[0] == 'F' ? std::atoi(key.data() + 1) : 0; }

bool belongs_to_navigation(const KeyEvent& e) {
  constexpr const char* kKeys[] = {"Left", "Right", "Up", "Down", "Space", "Enter", "Tab"};
  return std::find(std::begin(kKeys), std::end(kKeys), e.key) != std::end(kKeys);
}

}  // namespace

bool typing(const FrameContext& f) { return !f.state.field.empty() || ImGui::GetIO().WantTextInput; }

void dispatch(FrameContext& f, const KeyEvent& e) {
  if (typing(f) && function_key(e.key) == 0) {  // no field wants those
    if (e.key == "Esc") stop_typing(f);
    if (e.key == "Enter") f.state.entered = true;
    if (e.key == "Tab" || e.key == "Up" || e.key == "Down") f.state.field_key = e.key;
    return;
  }
  f.state.notice.clear();
  f.state.dismissed = f.input.message;
  if ((ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) && belongs_to_navigation(e)) return;
  f.state.caption.reset();
  if (press_in_panels(f, e) || press_command(f, e, true)) return;
  if (press_option(f, e) || press_view(f, e) || press_panel_key(f, e)) return;
  press_command(f, e, false);
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
  for (const KeyCommand& c : kCommands) rows.push_back({c.key, c.id, c.help, c.run != nullptr});
  for (const Panel* p : panels()) rows.push_back({p->key, p->id, help_of(*p)});
  std::stable_sort(rows.begin(), rows.end(),
                   [](const KeyRow& a, const KeyRow& b) { return function_key(a.key) < function_key(b.key); });
  return rows;
}

std::vector<KeyRow> mouse_rows() {
  std::vector<KeyRow> rows = {
      {"move", "mouse.read", "read the pixel: the status line, and the same place in every panel"},
      {"click", "mouse.hold", "hold the pixel and choose the view; the same pixel again, or a right click, lets go"},
      {"double", "mouse.enlarge", "a double click: the view alone; again, or 0: all views"},
      {"line", "mouse.wipe", "drag the line between A and B; a double click on it puts it in the middle"},
      {"drag", "mouse.look", "look around in the large picture; where it is zoomed, move it"},
      {"title", "mouse.swap", "drag a panel's title onto another panel: they change places"},
      {"middle", "mouse.pan", "drag with the middle button: move the picture"},
      {"wheel", "mouse.zoom", "zoom where the mouse is, in all panels; Shift: in this one alone"},
      {"right", "mouse.solo", "on R, G or B: that channel alone; again: all"}};
  for (KeyRow& r : rows) r.can_choose = false;
  return rows;
}

std::vector<KeyEvent> presses_of(const KeyRow& row) {
  const KeySpec spec = key_spec(row.key);
  std::vector<KeyEvent> presses;
  for (std::string name : spec.keys) {
    if (name.size() == 1) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    presses.push_back({name, spec.shift, spec.ctrl, false});
  }
  return presses;
}

}  // namespace gbl::ui
