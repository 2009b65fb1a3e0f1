#pragma once
// Where names stand beside their marks: on no mark, on no other name, within the frame.
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace gbl {

// Of a drawing, in its units, from a corner of the frame; which way y goes does not matter.
struct ChartMark {
  glm::dvec2 at;
  double radius;
};
struct LabelWish {
  glm::dvec2 at;    // its mark
  double radius;    // of the mark
  glm::dvec2 size;  // of the text
};
struct LabelBox {
  glm::dvec2 low, high;
  glm::dvec2 middle() const { return 0.5 * (low + high); }
  bool meets(const LabelBox& b) const {
    return glm::all(glm::lessThan(low, b.high)) && glm::all(glm::lessThan(b.low, high));
  }
};
struct PlacedLabel {
  LabelBox box;
  std::optional<glm::dvec2> line_to;  // where a line from the mark ends: the name does not stand next to it
};

// In the order of the wishes, each as near to its mark as is free; empty: there is no such place.
std::vector<std::optional<PlacedLabel>> place_labels(glm::dvec2 frame, std::span<const ChartMark>,
                                                     std::span<const LabelWish>);

}  // namespace gbl
