// PgDn without a lesson: one to choose.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

struct ChooserState : PanelState {
  size_t chosen = 0;
  std::vector<Lesson> lessons;
};

void open_chooser(FrameContext& f) {
  ChooserState& s = f.state.of<ChooserState>();
  s.lessons.clear();
  try {
    for (const std::string& id : lesson_ids()) s.lessons.push_back(load_lesson(id));
  } catch (const Error& e) {
    f.state.notice = e.what();  // those read so far can still be chosen
  }
  if (s.lessons.empty()) return say(f, {"There are no lessons.", ""});
  s.chosen = 0;
  s.open = true;
}

// The key of an open lesson steps in it.
void step_lesson(FrameContext& f, const KeyEvent& e) {
  State& s = f.state;
  if (!s.lesson) return open_chooser(f);
  const size_t n = s.lesson->lesson.steps.size();
  if (e.key == "PgDn" && s.lesson->step + 1 == n) return say(f, {"This is the lesson's last step; Esc closes it.", ""});
  if (e.key == "PgUp" && s.lesson->step == 0) return say(f, {"This is the lesson's first step.", ""});
  show_step(s, f.settings, e.key == "PgDn" ? s.lesson->step + 1 : s.lesson->step - 1);
}

void choose(FrameContext& f, size_t index) {
  const ChooserState& s = f.state.of<ChooserState>();
  if (index < s.lessons.size()) open_lesson(f.state, f.settings, {s.lessons[index]});
}

void move_choice(FrameContext& f, const KeyEvent& e) {
  ChooserState& s = f.state.of<ChooserState>();
  if (e.key == "Up")
    s.chosen -= std::min<size_t>(1, s.chosen);
  else
    s.chosen = std::min(s.chosen + 1, s.lessons.size() - 1);
}

void open_chosen(FrameContext& f, const KeyEvent&) { choose(f, f.state.of<ChooserState>().chosen); }
void open_number(FrameContext& f, const KeyEvent& e) { choose(f, static_cast<size_t>(e.key[0] - '1')); }

constexpr PanelKey kKeys[] = {
    {"Up Down", "choose", move_choice, true},
    {"Enter PgDn", "open it", open_chosen},
    {"1-9", "open that one", open_number},
};

Box chooser_box(const FrameContext& f) {
  const float row = std::round(f.type.large * 1.9f);
  const float rows = static_cast<float>(f.state.of<ChooserState>().lessons.size()) + 2;
  const Box& main = f.layout.main_box();
  const float width = main.width() * 0.8f, height = rows * row;
  const ImVec2 min{std::floor(main.min.x + (main.width() - width) / 2),
                   std::floor(main.min.y + std::max(0.0f, main.height() - height) / 2)};
  return {min, {min.x + width, min.y + height}};
}

void draw_chooser(FrameContext& f, Painter& p, const Box& box) {
  ChooserState& s = f.state.of<ChooserState>();
  const float px = f.type.large, row = std::round(px * 1.9f), pad = px * 0.6f;
  ImVec2 at{box.min.x + pad, box.min.y + pad / 2};
  p.text_in({at, {box.max.x - pad, at.y + row}}, px, theme().accent, "Which lesson?");
  at.y += row;
  std::optional<size_t> clicked;
  for (size_t i = 0; i < s.lessons.size(); ++i, at.y += row) {
    const Lesson& lesson = s.lessons[i];
    const Box line{{box.min.x + pad / 2, at.y}, {box.max.x - pad / 2, at.y + row - 2}};
    if (hit_area(lesson.id.c_str(), line)) clicked = i;
    if (ImGui::IsItemHovered()) s.chosen = i;
    if (i == s.chosen) p.outline(line, theme().accent, 2);
    const float top = at.y + (row - line_height(px)) / 2;
    const float cap = p.key_cap({at.x, top}, px, std::to_string(i + 1)) + pad;
    p.text_in({{at.x + cap, top}, {line.max.x - pad, line.max.y}}, px, theme().text,
              fmt::format("{}   ({} steps)", lesson.title, lesson.steps.size()));
  }
  p.text_in({{at.x, at.y + pad / 2}, {box.max.x - pad, at.y + row}}, f.type.small, theme().dim,
            "Up, Down and Enter, or its number; Esc closes");
  if (clicked) choose(f, *clicked);
}

}  // namespace

extern const Panel kLessonsPanel = {.key = "PgUp PgDn",
                                    .id = "lesson.step",
                                    .help = "a lesson's step back or on; none open: choose one",
                                    .place = Place::over,
                                    .box = chooser_box,
                                    .draw = draw_chooser,
                                    .keys = kKeys,
                                    .make = make_panel_state<ChooserState>,
                                    .press = step_lesson};

}  // namespace gbl::ui
