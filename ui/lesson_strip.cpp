// A lesson's step in the strip's place: its sentences, its question, and the answer when asked for.
#include <fmt/format.h>

#include "ui/state.h"

namespace gbl::ui {

void draw_lesson(FrameContext& f, const Box& strip) {
  const LessonRun& run = *f.state.lesson;
  const LessonStep& step = run.lesson.steps[run.step];
  const bool over_picture = f.state.hidden && f.state.large;
  const Theme& t = over_picture ? on_picture() : theme();
  f.painter.fill(strip, over_picture ? t.backing : t.background);
  const Box room = strip.inset(std::round(12 * f.layout.unit));
  const float px = f.type.small, head = line_height(px) + 2;
  const std::string place = fmt::format("{}   {}/{}", run.lesson.title, run.step + 1, run.lesson.steps.size());
  const std::string_view hint = !step.question.empty() && !run.revealed
                                    ? "Enter: the answer   PgUp PgDn: step   Esc closes"
                                    : "PgUp PgDn: step   Esc closes";
  const float hint_x = room.max.x - text_size(hint, px).x;
  f.painter.text({hint_x, room.min.y}, px, t.dim, hint);
  f.painter.text_in({room.min, {hint_x - px, room.min.y + head}}, px, t.accent, place);
  const float say_px = std::round(f.type.large * 1.3f);
  std::vector<Paragraph> paragraphs;
  paragraphs.push_back({step.say, t.text, say_px});
  if (!step.question.empty()) paragraphs.push_back({step.question, t.accent, say_px});
  // Invisible until asked for, but measured: nothing moves when it appears.
  if (!step.answer.empty()) paragraphs.push_back({step.answer, run.revealed ? t.text : 0, say_px});
  draw_paragraphs(f.painter, {{room.min.x, room.min.y + head}, room.max}, paragraphs, std::round(6 * f.layout.unit));
}

}  // namespace gbl::ui
