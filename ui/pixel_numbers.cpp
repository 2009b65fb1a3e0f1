#include "ui/pixel_numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gbl::ui {
namespace {

constexpr ImU32 kGridColour = IM_COL32(128, 128, 128, 110);

double screen_pixels(const Box& picture, const Zoom& zoom, glm::ivec2 frame) {
  return zoom.scale * picture.width() / frame.x;
}

}  // namespace

PixelGrid shown_pixels(const Zoom& zoom, glm::ivec2 frame) {
  const glm::dvec2 size(frame);
  const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(zoom.first() * size)), glm::ivec2(0));
  const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil((zoom.first() + 1 / zoom.scale) * size)), frame);
  return {first, {1, 1}, last - first};
}

void draw_grid(Painter& p, const Box& picture, const Zoom& zoom, glm::ivec2 frame) {
  if (screen_pixels(picture, zoom, frame) < kGridFrom) return;
  const PixelGrid shown = shown_pixels(zoom, frame);
  const glm::dvec2 size(frame);
  p.list().PushClipRect(picture.min, picture.max, true);
  for (int x = shown.first.x; x <= shown.first.x + shown.count.x; ++x) {
    const float at = picture.min.x + static_cast<float>(in_panel(zoom, {x / size.x, 0}).x) * picture.width();
    p.list().AddLine({at, picture.min.y}, {at, picture.max.y}, kGridColour);
  }
  for (int y = shown.first.y; y <= shown.first.y + shown.count.y; ++y) {
    const float at = picture.min.y + static_cast<float>(in_panel(zoom, {0, y / size.y}).y) * picture.height();
    p.list().AddLine({picture.min.x, at}, {picture.max.x, at}, kGridColour);
  }
  p.list().PopClipRect();
}

void draw_numbers(Painter& p, const Box& picture, const Zoom& zoom, glm::ivec2 frame, const PixelNumbers& n,
                  float most_px) {
  const double pixel_px = screen_pixels(picture, zoom, frame);
  if (pixel_px < kNumbersFrom) return;
  const int components = row(n.view).values.components;
  const float px = std::max(
      kSmallestPx, std::min(most_px, std::floor(static_cast<float>(pixel_px) / (components == 1 ? 4.5f : 5.5f))));
  const glm::dvec2 size(frame);
  p.list().PushClipRect(picture.min, picture.max, true);
  for (int y = 0; y < n.pixels.count.y; ++y)
    for (int x = 0; x < n.pixels.count.x; ++x) {
      const glm::vec4& value =
          n.values[static_cast<size_t>(y) * static_cast<size_t>(n.pixels.count.x) + static_cast<size_t>(x)];
      if (value.w <= 0.5f) continue;
      const glm::vec2 middle(in_panel(zoom, (glm::dvec2(n.pixels.first + glm::ivec2(x, y)) + 0.5) / size));
      ImVec2 at{picture.min.x + middle.x * picture.width(),
                picture.min.y + middle.y * picture.height() - px * 0.6f * static_cast<float>(components)};
      for (int c = 0; c < components; ++c, at.y += px * 1.2f) {
        const std::string text = fmt::format("{:.4g}", value[c]);
        const ImVec2 from{at.x - text_size(text, px).x / 2, at.y};
        p.text({from.x + 1, from.y + 1}, px, IM_COL32_BLACK, text);  // readable on light and dark
        p.text(from, px, IM_COL32_WHITE, text);
      }
    }
  p.list().PopClipRect();
}

}  // namespace gbl::ui
