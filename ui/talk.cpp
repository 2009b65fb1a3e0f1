#include "ui/talk.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/commands.h"

namespace gbl::ui {
namespace {

// What is said at a step, as far as its first full stop or question mark.
std::string first_sentence(const std::string& say) {
  for (size_t i = 0; i + 1 < say.size(); ++i)
    if (std::string_view(".?").find(say[i]) != std::string_view::npos && say[i + 1] == ' ') return say.substr(0, i);
  return say;
}

// The present one has a sign of its own, and so have those that are done.
std::vector<Field> steps_of(const LessonRun& run) {
  std::vector<Field> fields;
  for (size_t i = 0; i < run.lesson.steps.size(); ++i) {
    const bool now = i == run.step;
    fields.push_back({fmt::format("{} {}",
                                  now            ? "▶"
                                  : i < run.step ? "✓"
                                                 : "–",
                                  i + 1),
                      first_sentence(run.lesson.steps[i].say), now ? on_picture().accent : on_picture().text});
  }
  return fields;
}

std::string minutes(double seconds) {
  const auto whole = static_cast<long>(std::max(0.0, seconds));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

void toggle_talk_timer(FrameContext& f, const KeyEvent&) {
  std::optional<double>& began = f.state.talk_began;
  began = began ? std::nullopt : std::optional(f.input.seconds);
}

void toggle_reticle(FrameContext& f, const KeyEvent&) {
  f.state.reticle = !f.state.reticle;
  say(f, {f.state.reticle ? "A ring points on the pictures. F9 takes it away." : "The ring is gone.", ""});
}

// In the lower right corner of the large picture: no legend stands there.
void draw_talk_timer(FrameContext& f) {
  if (!f.state.talk_began) return;
  const double seconds = f.input.seconds - *f.state.talk_began;
  const double until_next = 1 - (seconds - std::floor(seconds));
  f.requests.wake_in = std::min(f.requests.wake_in.value_or(until_next), until_next);
  const Box& main = f.layout.main_box();
  const float px = f.type.large * 1.6f, pad = std::round(f.type.body * 0.6f);
  const std::string time = minutes(seconds);
  std::vector<Field> steps;
  if (f.state.lesson) steps = steps_of(*f.state.lesson);
  const float width = steps.empty() ? text_size(time, px).x : std::min(main.width() * 0.5f, f.type.body * 26);
  const float list = steps.empty() ? 0 : std::min(main.height() * 0.5f, 2.6f * f.type.body * float(steps.size()));
  const ImVec2 corner{main.max.x - 4, main.max.y - 4 - f.layout.foot};
  const Box box{{corner.x - width - 2 * pad, corner.y - line_height(px) - list - 2 * pad}, corner};
  f.painter.fill(box, on_picture().backing, 4);
  const Box room = box.inset(pad);
  f.painter.text({room.max.x - text_size(time, px).x, room.min.y}, px, on_picture().text, time);
  if (steps.empty()) return;
  draw_fields(f.painter, {{room.min.x, room.min.y + line_height(px)}, room.max}, steps, f.type.body, on_picture().dim);
}

void draw_reticle(FrameContext& f) {
  if (!f.state.reticle || !f.state.hovered) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float radius = f.type.large * 1.3f, width = std::max(3.0f, f.type.large * 0.2f);
  list.AddCircle(at, radius, IM_COL32_BLACK, 64, 2 * width);  // dark on both sides: it shows on light and on dark
  list.AddCircle(at, radius, on_picture().accent, 64, width);
}

}  // namespace gbl::ui
