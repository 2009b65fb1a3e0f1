#include "ui/presenting.h"

#include <algorithm>
#include <cmath>

namespace gbl::ui {
namespace {

constexpr float kMostOfThePicture = 0.3f;  // a longer lesson is set in smaller type

struct Foot {
  std::string key;  // of the view; of a lesson: what goes on from here
  std::vector<Paragraph> paragraphs;
  Box box;
  float pad, gap, cap;  // cap: width that the key takes
};

// The answer takes the place of what was said: the class has heard it.
void add_lesson(Foot& foot, const LessonRun& run, float px) {
  const LessonStep& step = run.lesson.steps[run.step];
  const bool asks = !step.question.empty(), last = run.step + 1 == run.lesson.steps.size();
  foot.key = asks && !run.revealed ? "Enter" : last ? "Esc" : "PgDn";
  if (!asks || !run.revealed) foot.paragraphs.push_back({step.say, on_picture().text, px});
  if (asks) foot.paragraphs.push_back({step.question, on_picture().accent, px});
  if (asks && run.revealed) foot.paragraphs.push_back({step.answer, on_picture().text, px});
}

Foot foot_of(const FrameContext& f) {
  Foot foot;
  const float px = f.type.large;
  if (f.state.lesson) {
    add_lesson(foot, *f.state.lesson, px);
  } else {
    foot.key = row(f.chosen()).key;
    foot.paragraphs = {{row(f.chosen()).sentence, on_picture().text, px}};
  }
  foot.pad = std::round(12 * f.layout.unit);
  foot.gap = std::round(6 * f.layout.unit);
  foot.cap = foot.key.empty() ? 0 : key_cap_width(foot.key, px) + foot.pad;
  const Box& strip = f.layout.strip;
  float height = 2 * foot.pad - foot.gap;
  for (const Paragraph& q : foot.paragraphs)
    height += text_size(q.text, q.px, strip.width() - 2 * foot.pad - foot.cap).y + foot.gap;
  const float most = f.state.large ? kMostOfThePicture * f.layout.canvas.height() : strip.height();
  foot.box = {{strip.min.x, strip.max.y - std::min(std::ceil(height), most)}, strip.max};
  return foot;
}

}  // namespace

float presenting_foot(const FrameContext& f) {
  if (!f.state.present || f.state.hidden || !f.state.large) return 0;
  const Box& main = f.layout.main_box();
  return std::clamp(main.max.y - foot_of(f).box.min.y, 0.0f, main.height());
}

void draw_presenting(FrameContext& f) {
  const Foot foot = foot_of(f);
  f.painter.fill(foot.box, on_picture().backing);
  const Box room = foot.box.inset(foot.pad);
  if (!foot.key.empty()) f.painter.key_cap(room.min, f.type.large, foot.key);
  draw_paragraphs(f.painter, {{room.min.x + foot.cap, room.min.y}, room.max}, foot.paragraphs, foot.gap);
}

}  // namespace gbl::ui
