// The loupe: the main view around the held pixel, each pixel a square of one colour.
#include <fmt/format.h>

#include "ui/panels/pixel_parts.h"

namespace gbl::ui {
namespace {

constexpr int kReach = 5;  // pixels to each side of the held one
constexpr int kAcross = 2 * kReach + 1;

// In the middle of a pixel the texture has that pixel's own colour, however it is filtered.
void draw_square(Painter& p, const ViewImage& image, const Box& square, glm::dvec2 middle) {
  const ImVec2 at{static_cast<float>(middle.x), static_cast<float>(1 - middle.y)};
  p.list().AddImage(reinterpret_cast<ImTextureID>(image.texture), square.min, square.max, at, at);
}

const glm::vec4* number_of(const FrameContext& f, View v, glm::ivec2 pixel) {
  const PixelNumbers* n = f.input.numbers;
  if (!n || n->view != v || n->pixels.step != glm::ivec2(1)) return nullptr;
  const glm::ivec2 at = pixel - n->pixels.first;
  if (at.x < 0 || at.y < 0 || at.x >= n->pixels.count.x || at.y >= n->pixels.count.y) return nullptr;
  return &n->values[static_cast<size_t>(at.y) * static_cast<size_t>(n->pixels.count.x) + static_cast<size_t>(at.x)];
}

}  // namespace

float loupe_side(const FrameContext& f) { return kAcross * std::round(11 * f.layout.unit); }

void draw_loupe(FrameContext& f, Painter& p, const Box& box) {
  const ViewImage& image = f.input.images[static_cast<size_t>(f.layout.main)];
  const glm::ivec2 size = f.frame_size(), held = *f.held_pixel();
  const float side = std::floor(box.width() / kAcross);
  p.fill(box, IM_COL32_BLACK);
  const auto square_at = [&](int x, int y) {
    const ImVec2 min{box.min.x + static_cast<float>(x + kReach) * side,
                     box.min.y + static_cast<float>(y + kReach) * side};
    return Box{min, {min.x + side, min.y + side}};
  };
  for (int y = -kReach; y <= kReach && image.texture; ++y)
    for (int x = -kReach; x <= kReach; ++x) {
      const glm::ivec2 pixel = held + glm::ivec2(x, y);
      if (pixel != glm::clamp(pixel, glm::ivec2(0), size - 1)) continue;  // beside the picture
      draw_square(p, image, square_at(x, y), (glm::dvec2(pixel) + 0.5) / glm::dvec2(size));
    }
  const Box middle = square_at(0, 0);
  p.outline(middle.inset(-2), IM_COL32_BLACK, 1);
  p.outline(middle.inset(-1), theme().accent, 1);
}

std::string loupe_numbers(FrameContext& f) {
  const View v = f.layout.main;
  const glm::ivec2 held = *f.held_pixel();
  std::string name = row(v).label;
  if (needs_truth(v) || !why_missing(v, f.stored).empty()) return name;
  if (!f.requests.numbers) f.requests.numbers = {v, PixelGrid{held, {1, 1}, {1, 1}}};
  const glm::vec4* value = number_of(f, v, held);
  if (!value) return name + "  …";
  if (value->w <= 0.5f) return name + "  no number here";
  std::vector<double> shown;
  for (int c = 0; c < row(v).values.components; ++c) shown.push_back((*value)[c]);
  return fmt::format("{}  {}", name, numbers(shown));
}

}  // namespace gbl::ui
