// Lessons: one to choose, then its sentences in the strip's place, its question, and the answer when asked for.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "ui/commands.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

void open_chooser(FrameContext& f) {
  State& s = f.state;
  s.lessons.clear();
  try {
    for (const std::string& id : lesson_ids()) s.lessons.push_back(load_lesson(id));
  } catch (const Error& e) {
    s.notice = e.what();  // those read so far can still be chosen
  }
  if (s.lessons.empty()) return say(f, {"There are no lessons.", ""});
  s.chooser = 0;
}

void choose(FrameContext& f, int index) {
  if (index >= 0 && index < static_cast<int>(f.state.lessons.size()))
    open_lesson(f.state, f.settings, f.state.lessons[static_cast<size_t>(index)]);
}

}  // namespace

void step_lesson(FrameContext& f, const KeyEvent& e) {
  State& s = f.state;
  if (!s.lesson) return open_chooser(f);
  const size_t n = s.lesson->lesson.steps.size();
  if (e.key == "PgDn" && s.lesson->step + 1 == n) return say(f, {"This is the lesson's last step; Esc closes it.", ""});
  if (e.key == "PgUp" && s.lesson->step == 0) return say(f, {"This is the lesson's first step.", ""});
  show_step(s, f.settings, e.key == "PgDn" ? s.lesson->step + 1 : s.lesson->step - 1);
}

void reveal_answer(FrameContext& f, const KeyEvent&) {
  if (f.state.lesson) f.state.lesson->revealed = true;
}

// Up and Down move, Enter or PgDn opens, a digit opens at once.
bool press_in_chooser(FrameContext& f, const KeyEvent& e) {
  int& chosen = *f.state.chooser;
  const int last = static_cast<int>(f.state.lessons.size()) - 1;
  if (e.key == "Up")
    chosen = std::max(0, chosen - 1);
  else if (e.key == "Down")
    chosen = std::min(last, chosen + 1);
  else if (e.key == "Enter" || e.key == "PgDn")
    choose(f, chosen);
  else if (e.key.size() == 1 && e.key[0] >= '1' && e.key[0] <= '9')
    choose(f, e.key[0] - '1');
  else
    return false;
  return true;
}

void draw_chooser(FrameContext& f) {
  if (!f.state.chooser) return;
  const float px = f.type.large, row = std::round(px * 1.9f);
  const float rows = static_cast<float>(f.state.lessons.size()) + 2;
  const Box& main = f.layout.main_box();
  const float width = main.width() * 0.8f, height = rows * row;
  const ImVec2 min{std::floor(main.min.x + (main.width() - width) / 2),
                   std::floor(main.min.y + std::max(0.0f, main.height() - height) / 2)};
  begin_overlay("lessons", {min, {min.x + width, min.y + height}}, kSurface);
  Painter p(*ImGui::GetWindowDrawList(), f.state.cut_texts);
  const float pad = px * 0.6f;
  ImVec2 at{min.x + pad, min.y + pad / 2};
  p.text_in({at, {min.x + width - pad, at.y + row}}, px, kAccent, "Which lesson?");
  at.y += row;
  int clicked = -1;
  for (int i = 0; i < static_cast<int>(f.state.lessons.size()); ++i, at.y += row) {
    const Lesson& lesson = f.state.lessons[static_cast<size_t>(i)];
    const Box line{{min.x + pad / 2, at.y}, {min.x + width - pad / 2, at.y + row - 2}};
    ImGui::SetCursorScreenPos(line.min);
    if (ImGui::InvisibleButton(lesson.id.c_str(), line.size())) clicked = i;
    if (ImGui::IsItemHovered()) f.state.chooser = i;
    if (i == *f.state.chooser) p.outline(line, kAccent, 2);
    const float top = at.y + (row - line_height(px)) / 2;
    const float cap = p.key_cap({at.x, top}, px, std::to_string(i + 1)) + pad;
    p.text_in({{at.x + cap, top}, {line.max.x - pad, line.max.y}}, px, kText,
              fmt::format("{}   ({} steps)", lesson.title, lesson.steps.size()));
  }
  p.text_in({{at.x, at.y + pad / 2}, {min.x + width - pad, at.y + row}}, f.type.small, kDim,
            "Up, Down and Enter, or its number; Esc closes");
  end_overlay();
  choose(f, clicked);
}

void draw_lesson(FrameContext& f, const Box& strip) {
  const LessonRun& run = *f.state.lesson;
  const LessonStep& step = run.lesson.steps[run.step];
  f.painter.fill(strip, f.state.hidden && f.state.large ? kBacking : kBackground);
  const Box room = strip.inset(std::round(12 * f.layout.unit));
  const float px = f.type.small, head = line_height(px) + 2;
  const std::string place = fmt::format("{}   {}/{}", run.lesson.title, run.step + 1, run.lesson.steps.size());
  const std::string_view hint = !step.question.empty() && !run.revealed
                                    ? "Enter: the answer   PgUp PgDn: step   Esc closes"
                                    : "PgUp PgDn: step   Esc closes";
  const float hint_x = room.max.x - text_size(hint, px).x;
  f.painter.text({hint_x, room.min.y}, px, kDim, hint);
  f.painter.text_in({room.min, {hint_x - px, room.min.y + head}}, px, kAccent, place);
  const float say_px = std::round(f.type.large * 1.3f);
  std::vector<Paragraph> paragraphs;
  // In large type the answer takes the place of what was said: the class has heard it.
  if (!f.state.present || !run.revealed || step.answer.empty()) paragraphs.push_back({step.say, kText, say_px});
  if (!step.question.empty()) paragraphs.push_back({step.question, kAccent, say_px});
  // Invisible until asked for, but measured: nothing moves when it appears.
  const bool measured = run.revealed || !f.state.present;
  if (measured && !step.answer.empty()) paragraphs.push_back({step.answer, run.revealed ? kText : 0, say_px});
  draw_paragraphs(f.painter, {{room.min.x, room.min.y + head}, room.max}, paragraphs, std::round(6 * f.layout.unit));
}

}  // namespace gbl::ui
