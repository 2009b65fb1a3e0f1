// The error view in numbers: largest, mean and percentile with the worst pixel, and a histogram; or how far the
// reference has come.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "ui/state.h"

namespace gbl::ui {
namespace {

// Bars of log counts: a single pixel still shows beside a hundred thousand.
void draw_histogram(Painter& p, const Box& box, const ErrorStats& stats) {
  const size_t most = *std::max_element(stats.histogram.begin(), stats.histogram.end());
  if (most == 0) return;
  const float step = box.width() / ErrorStats::kBins;
  for (int i = 0; i < ErrorStats::kBins; ++i) {
    const size_t n = stats.histogram[static_cast<size_t>(i)];
    if (n == 0) continue;
    const auto share = static_cast<float>(std::log1p(double(n)) / std::log1p(double(most)));
    const float left = box.min.x + step * static_cast<float>(i);
    p.fill({{left, box.max.y - std::max(2.0f, share * box.height())}, {left + step - 1, box.max.y}}, on_picture().dim);
  }
  p.fill({{box.min.x, box.max.y}, {box.max.x, box.max.y + 1}}, on_picture().text);
}

std::string numbers_text(const ErrorStats& e) {
  const std::string left_out =
      e.ties == 0 ? "" : fmt::format(" ({} edge pixel{} left out)", e.ties, e.ties == 1 ? "" : "s");
  std::string text = fmt::format("largest {:.3g}{}   p99 {:.3g}   mean {:.3g}   signed mean {:+.2g}   {}", e.max,
                                 left_out, e.p99, e.mean, e.signed_mean, unit_of(e.of));
  if (e.nonfinite > 0) text += fmt::format("   {} {} pixels are not finite", kUnsoundSign, e.nonfinite);
  return text;
}

bool draws_forward(const FrameContext& f) {
  const std::vector<Material>& all = f.input.scene.materials;
  return f.settings.lights.markers == LightMarkers::on ||
         std::any_of(all.begin(), all.end(), [](const Material& m) { return m.alpha_mode == AlphaMode::blend; });
}

void draw_stats(FrameContext& f, const Box& panel, const ErrorStats& stats) {
  const float px = f.type.body, line = line_height(px), pad = std::round(px * 0.5f);
  std::string text = numbers_text(stats);
  if (draws_forward(f)) text += "   glass and light cubes are not judged";
  const std::string worst =
      stats.worst.x < 0
          ? "no surface is compared"
          : fmt::format("worst pixel {}, {} (J holds it)   pixels by error, log count:", stats.worst.x, stats.worst.y);
  const float histogram = px * 14;
  const float width = std::max(text_size(text, px).x, text_size(worst, px).x + pad + histogram) + 2 * pad;
  const float top = panel.min.y + 10 + line_height(f.type.small);  // below the buttons
  const Box back{{panel.max.x - std::min(width, panel.width() - 8) - 4, top},
                 {panel.max.x - 4, top + 3 * line + 2 * pad}};
  f.painter.fill(back, on_picture().backing);
  const Box room = back.inset(pad);
  f.painter.text_in({room.min, {room.max.x, room.min.y + line}}, px, on_picture().text, text);
  f.painter.text_in({{room.min.x, room.min.y + line}, {room.max.x - histogram - pad, room.max.y}}, px, on_picture().dim,
                    worst, true);
  draw_histogram(f.painter, {{room.max.x - histogram, room.min.y + line + pad}, room.max}, stats);
}

void draw_progress(FrameContext& f, const Box& panel) {
  const std::string text = fmt::format("working out the reference: {:.0f} %", 100 * f.input.truth_progress);
  const float px = f.type.large;
  const ImVec2 size = text_size(text, px);
  const Box back{{panel.min.x + (panel.width() - size.x) / 2 - px, panel.min.y + panel.height() / 2 - size.y},
                 {panel.min.x + (panel.width() + size.x) / 2 + px, panel.min.y + panel.height() / 2 + size.y}};
  f.painter.fill(back, on_picture().backing);
  f.painter.text({back.min.x + px, back.min.y + size.y / 2}, px, on_picture().accent, text);
}

}  // namespace

void draw_error_numbers(FrameContext& f, const Box& panel) {
  if (!needs_truth(f.layout.main) || !why_missing(f.layout.main, f.stored).empty()) return;
  if (f.input.truth_progress < 1) return draw_progress(f, panel);
  if (f.layout.main == View::error && f.input.error) draw_stats(f, panel, *f.input.error);
}

}  // namespace gbl::ui
