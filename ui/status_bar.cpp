// At the bottom: one pixel in words and numbers, what is stored and what is shown; right: the time.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/gbuffer/layouts.h"
#include "renderer/picture/srgb.h"
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

std::string right_text(const FrameContext& f) {
  std::string text;
  if (const ChartInput* c = f.input.chart; c && !c->running.empty() && !is_open(f.state, "chart"))
    text += fmt::format("F3: study “{}” {}/{}   ", c->running, c->done, c->total);
  if (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) text += "panel keys on, Esc leaves   ";
  if (f.state.held_at) text += "pixel held, Esc lets go   ";
  return text + fmt::format("t = {:.2f} s {}", f.settings.time_s, f.state.playing ? "running" : "paused");
}

}  // namespace

float status_height(const Type& type) { return std::round(type.small * 1.92f); }

void draw_status_bar(FrameContext& f) {
  const Box& bar = f.layout.status;
  f.painter.fill(bar, theme().surface);
  const float px = f.type.small, pad = px * 0.8f, y = std::floor((bar.min.y + bar.max.y - px * 1.17f) / 2);
  const std::string right = right_text(f);
  const float right_x = bar.max.x - pad - text_size(right, px).x;
  f.painter.text({right_x, y}, px, theme().dim, right);

  std::string left = "Point at a picture to read its pixel here; a click holds it. F1 shows the keys.";
  if (f.input.probe && (f.state.held_at || f.state.hovered_pixel)) left = pixel_in_words(f, *f.input.probe);
  f.painter.text_in({{bar.min.x + pad, y}, {right_x - 2 * pad, bar.max.y}}, px, theme().text, left);
}

}  // namespace gbl::ui
