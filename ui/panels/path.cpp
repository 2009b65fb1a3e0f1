// Ctrl+O: a path is typed, Tab completes it, Enter opens it as if it had been dropped. It goes when its field is left.
#include <array>
#include <fmt/format.h>
#include <utility>

#include "ui/panels/side_panel.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

constexpr const char* kField = "file.open";
constexpr size_t kMostMatches = 8;  // on screen

struct PathState : PanelState {
  std::array<char, 1024> text{};
  std::optional<std::string> put;  // into the field, when it is there
  bool completing = false;         // Tab was pressed; the answer is still to come
  size_t recent = 0;               // that Down has come to, from 1; 0: none
  std::string file;                // to be opened
};

const PathInput& path_input(const FrameContext& f) {
  static const PathInput kNone;
  return f.input.path ? *f.input.path : kNone;
}

void put_text(FrameContext& f, const std::string& text) {
  PathState& s = f.state.of<PathState>();
  s.text = {};
  text.copy(s.text.data(), s.text.size() - 1);
  s.put = s.text.data();
  if (f.state.field != kField) f.state.type_into(kField);
}

void open_path(FrameContext& f, const KeyEvent&) {
  PathState& s = f.state.of<PathState>();
  s.open = true;
  s.completing = false;
  s.recent = 0;
  f.state.type_into(kField);
}

// The panel is left: its field is.
void open_file(FrameContext& f, const std::string& file) {
  f.state.of<PathState>().file = file;
  f.state.field.clear();
}

void complete(FrameContext& f) {
  PathState& s = f.state.of<PathState>();
  const PathInput& in = path_input(f);
  if (f.state.field_key == "Tab") s.completing = true;
  if (!s.completing || in.asked != s.text.data()) return;
  s.completing = false;
  if (in.completed != in.asked) put_text(f, in.completed);
}

void walk_recent(FrameContext& f) {
  PathState& s = f.state.of<PathState>();
  const std::vector<std::string>& recent = path_input(f).recent;
  if (f.state.field_key == "Down" && s.recent < recent.size()) put_text(f, recent[s.recent++]);
  if (f.state.field_key == "Up" && s.recent > 1) put_text(f, recent[--s.recent - 1]);
}

void enter(FrameContext& f) {
  const PathState& s = f.state.of<PathState>();
  const PathInput& in = path_input(f);
  const std::string text = s.text.data();
  if (in.asked == text && in.folder && !text.empty())
    put_text(f, text.back() == '/' ? text : text + "/");
  else
    open_file(f, text);
}

// ---- drawing -------------------------------------------------------------------------------------------------------
Box path_box(const FrameContext& f) {
  const PathInput& in = path_input(f);
  const float px = f.type.body, line = line_height(px) * 1.25f;  // with the gap below it
  const size_t matches = std::min(in.matches.size(), kMostMatches), recent = in.recent.size();
  const size_t lines = 6 + matches + (recent > 0 ? recent + 1 : 0);
  const Box& canvas = f.layout.canvas;
  const float width = std::min(canvas.width(), px * 60);
  const float height = std::min(canvas.height(), static_cast<float>(lines) * line);
  const ImVec2 min{std::floor(canvas.min.x + (canvas.width() - width) / 2), canvas.min.y};
  return {min, {min.x + width, std::floor(min.y + height)}};
}

// The end of a path says more than its beginning.
std::string end_of(std::string_view path, float px, float width) {
  if (text_size(path, px).x <= width) return std::string(path);
  while (!path.empty() && text_size(fmt::format("…{}", path), px).x > width) {
    path.remove_prefix(1);
    while (!path.empty() && (path[0] & 0xC0) == 0x80) path.remove_prefix(1);  // the rest of a letter
  }
  return fmt::format("…{}", path);
}

// A line that acts when it is pressed, before the field that is left by the same press closes the panel.
bool draw_line(FrameContext& f, Painter& p, const Box& line, const std::string& path, ImU32 colour) {
  const bool hovered = ImGui::IsMouseHoveringRect(line.min, line.max, false);
  if (hovered) p.fill(line, theme().raised, 3);
  p.text({line.min.x + f.type.body * 0.4f, line.min.y}, f.type.body, hovered ? theme().text : colour,
         end_of(path, f.type.body, line.width() - f.type.body));
  return hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

void draw_matches(FrameContext& f, Painter& p, Shelf& shelf, float line) {
  const PathInput& in = path_input(f);
  const std::string folder = in.asked.substr(0, in.asked.rfind('/') + 1);
  size_t shown = 0;
  for (; shown < std::min(in.matches.size(), kMostMatches) && shelf.room.height() > 2 * line; ++shown) {
    const std::string& name = in.matches[shown];
    if (!draw_line(f, p, shelf.below(line), name, theme().text)) continue;
    if (name.back() == '/')
      put_text(f, folder + name);
    else
      open_file(f, folder + name);
  }
  std::string words = in.note;
  if (words.empty() && in.matches.empty()) words = "nothing that can be opened begins like this";
  if (shown < in.matches.size()) words = fmt::format("and {} more", in.matches.size() - shown);
  if (words.empty()) return;
  p.text_in(shelf.below(line_height(f.type.small)), f.type.small, in.note.empty() ? theme().dim : theme().accent,
            words);
}

void draw_recent(FrameContext& f, Painter& p, Shelf& shelf, float line) {
  const std::vector<std::string>& recent = path_input(f).recent;
  if (recent.empty() || shelf.room.height() < 3 * line) return;
  p.text_in(shelf.below(line), f.type.body, theme().accent, "Opened lately");
  for (const std::string& file : recent)
    if (shelf.room.height() > line && draw_line(f, p, shelf.below(line), file, theme().dim)) open_file(f, file);
}

void draw_path(FrameContext& f, Painter& p, const Box& box) {
  PathState& s = f.state.of<PathState>();
  const float line = line_height(f.type.body);
  complete(f);
  walk_recent(f);
  Shelf shelf{box.inset(std::round(f.type.body * 0.8f)), std::round(f.type.body * 0.25f)};
  p.text_in(shelf.below(line), f.type.body, theme().accent, "Open a model, settings, a rig or a picture");
  const std::string before = s.text.data();
  if (draw_text_field(f, kField, shelf.below(std::round(1.6f * line)), f.type.body, s.text.data(), s.text.size(),
                      &s.put))
    enter(f);
  if (before != s.text.data() && f.state.field_key.empty()) s.recent = 0;
  p.text_in(shelf.below(line_height(f.type.small)), f.type.small, theme().dim,
            "Tab completes · ↑ ↓ opened lately · Enter opens · Esc closes");
  draw_matches(f, p, shelf, line);
  draw_recent(f, p, shelf, line);
}

void ask(FrameContext& f) {
  PathState& s = f.state.of<PathState>();
  if (f.state.field != kField) s.open = false;
  f.requests.path = {s.open, s.text.data(), std::exchange(s.file, "")};
}

}  // namespace

extern const Panel kPathPanel = {.key = "Ctrl+O",
                                 .id = "file.open",
                                 .help = "type the path of a model, settings, a picture or a rig to open",
                                 .place = Place::over,
                                 .box = path_box,
                                 .draw = draw_path,
                                 .make = make_panel_state<PathState>,
                                 .press = open_path,
                                 .update = ask};

}  // namespace gbl::ui
