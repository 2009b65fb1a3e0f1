#include "ui/in_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/gbuffer/layouts.h"
#include "renderer/picture/srgb.h"
#include "ui/figure.h"
#include "ui/panel.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

// The display transform of one channel: the same words as the card of `final`.
int shown_code(float lit, const Settings& s) {
  const double x = std::clamp(lit * s.exposure, 0.0, 1.0);
  if (s.colour == Colour::as_tutorial) return static_cast<int>(std::lround(255 * x));
  return static_cast<int>(std::lround(255 * srgb_from_linear(x)));
}

std::string facing(const glm::vec3& n) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
  const char* mostly = std::abs(n[axis]) > 0.95f ? "" : "mostly ";
  if (axis == 1) return fmt::format("{}{}", mostly, n.y > 0 ? "up" : "down");
  return fmt::format("{}to {}{}", mostly, n[axis] > 0 ? '+' : '-', "XYZ"[axis]);
}

const char* roughness_word(float r) { return r < 0.3f ? "shiny" : r < 0.65f ? "satin" : "matt"; }

std::string three(const glm::vec3& v, int digits) {
  return fmt::format("{:.{}f} {:.{}f} {:.{}f}", v.x, digits, v.y, digits, v.z, digits);
}

std::string step_in_words(const LessonRun& run) {
  const LessonStep& step = run.lesson.steps[run.step];
  std::string text =
      fmt::format("Lesson “{}”, step {} of {}: {}", run.lesson.title, run.step + 1, run.lesson.steps.size(), step.say);
  if (!step.question.empty()) text += " " + step.question;
  if (run.revealed) text += " " + step.answer;
  return text;
}

}  // namespace

std::string shown_in_words(const FrameContext& f, View v) {
  std::string text = fmt::format("{}: {}", row(v).label, row(v).sentence);
  const ViewLook look = look_of(f.settings.view.looks, row(v).id);
  if (!look.plain()) text += fmt::format(" Looked at as {}.", text_of(LookOf{row(v).id, look}));
  const Zoom zoom = zoom_of(f, v);
  if (!zoom.whole())
    text += fmt::format(" {:.3g} times as large, about {:.3g} across and {:.3g} down.", zoom.scale, zoom.centre.x,
                        zoom.centre.y);
  return text;
}

std::string pixel_in_words(const FrameContext& f, const PixelProbe& p) {
  std::string text = fmt::format("pixel {}, {}", p.pixel.x, p.pixel.y);
  if (p.object() > 0) text += fmt::format("   {}", object_name(p, f.input.scene));
  if (!p.surface()) return text + "   no surface: the background";
  text += fmt::format("   albedo {}", three(p.vector(ProbeField::albedo), 2));
  const float roughness = p.number(ProbeField::roughness), lights = p.number(ProbeField::lights);
  if (layout_of(f.stored).stores_roughness())
    text += fmt::format("   roughness {:.2f} {}", roughness, roughness_word(roughness));
  const glm::vec3 normal = p.vector(ProbeField::normal), lit = p.vector(ProbeField::lit);
  text +=
      fmt::format("   normal {} {}   {:.1f} units away", three(normal, 2), facing(normal), p.number(ProbeField::range));
  return text + fmt::format("   {:.0f} light{}   lit {} → shown {} {} {}", lights, lights == 1 ? "" : "s",
                            three(lit, 3), shown_code(lit.r, f.settings), shown_code(lit.g, f.settings),
                            shown_code(lit.b, f.settings));
}

std::string in_words(const FrameContext& f) {
  std::string text = shown_in_words(f, f.layout.main);
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) text += "\n" + sentence;
  };
  add(made_in_words(f.settings, f.input.report));
  if (f.input.probe && (f.state.held_at || f.state.hovered_pixel)) add(pixel_in_words(f, *f.input.probe));
  if (f.state.lesson) add(step_in_words(*f.state.lesson));
  add(panels_in_words(f));
  if (f.state.caption) add(f.state.caption->sentence.whole());
  add(f.state.notice);
  add(f.input.message);
  return text;
}

}  // namespace gbl::ui
