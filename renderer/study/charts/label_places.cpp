#include "renderer/study/charts/label_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gbl {
namespace {

constexpr double kGap = 2;   // between a mark and its name
constexpr double kStep = 6;  // from one ring of places to the next
constexpr int kRings = 60;
// Twenty-fourths of a turn, from straight along y: where a name is read best comes first.
constexpr int kTurns[] = {0, 12, 6, 18, 3, 21, 9, 15, 1, 23, 5, 19, 7, 17, 11, 13, 2, 22, 4, 20, 8, 16, 10, 14};
constexpr double kLineFrom = 14;  // farther away a line says whose name it is

LabelBox round(const ChartMark& m) { return {m.at - m.radius, m.at + m.radius}; }

LabelBox box_at(const LabelWish& w, double distance, int turn) {
  const double angle = 2 * std::numbers::pi * turn / std::size(kTurns);
  const glm::dvec2 way(std::sin(angle), std::cos(angle));
  const glm::dvec2 middle = w.at + way * (w.radius + distance + 0.5 * w.size);
  return {middle - 0.5 * w.size, middle + 0.5 * w.size};
}

bool inside(const LabelBox& b, glm::dvec2 frame) {
  return b.low.x >= 0 && b.low.y >= 0 && b.high.x <= frame.x && b.high.y <= frame.y;
}

}  // namespace

std::vector<std::optional<PlacedLabel>> place_labels(glm::dvec2 frame, std::span<const ChartMark> marks,
                                                     std::span<const LabelWish> wishes) {
  std::vector<LabelBox> taken;
  for (const ChartMark& m : marks) taken.push_back(round(m));
  const auto is_free = [&](const LabelBox& box) {
    return inside(box, frame) &&
           std::none_of(taken.begin(), taken.end(), [&](const LabelBox& t) { return t.meets(box); });
  };
  const auto place = [&](const LabelWish& w) -> std::optional<PlacedLabel> {
    for (int ring = 0; ring < kRings; ++ring)
      for (const int turn : kTurns) {
        const double distance = kGap + kStep * ring;
        const LabelBox box = box_at(w, distance, turn);
        if (!is_free(box)) continue;
        taken.push_back(box);
        if (distance < kLineFrom) return PlacedLabel{box, {}};
        return PlacedLabel{box, glm::clamp(w.at, box.low, box.high)};
      }
    return {};
  };
  std::vector<std::optional<PlacedLabel>> out;
  for (const LabelWish& w : wishes) out.push_back(place(w));
  return out;
}

}  // namespace gbl
