// At the bottom: one pixel in words and numbers, what is stored and what is shown; right: the time.
#include <cmath>
#include <fmt/format.h>

#include "ui/in_words.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

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
