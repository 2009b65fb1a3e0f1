#include "renderer/truth/bvh.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace gbl {
namespace {

constexpr int kBins = 16;
constexpr uint32_t kLeaf = 4;  // items that are not told apart further
// From this depth on halves of equal number, so that no scene makes a deep tree: 2^32 items need 32 more.
constexpr size_t kDeep = 64;

void grow(Bounds& b, const Bounds& other) { include(b, other.min), include(b, other.max); }

double half_area(const Bounds& b) {
  const glm::dvec3 e = glm::max(b.extent(), glm::dvec3(0));
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

// A little larger, so that the rounding of the ray's own arithmetic never loses what lies on a side.
Bounds padded(const Bounds& b) {
  constexpr double kShare = 1e-12;
  const glm::dvec3 pad = kShare * glm::max(glm::abs(b.min), glm::abs(b.max)) + 1e-300;
  return {b.min - pad, b.max + pad};
}

}  // namespace

struct Bvh::Build {
  std::span<const Bounds> boxes;
  glm::dvec3 centre(uint32_t item) const { return boxes[item].centre(); }

  struct Split {
    int axis = -1;  // -1: no split is worth it
    double at = 0;
  };
  // Where the sum of (area x items) of both sides is least.
  Split best_split(std::span<const uint32_t> items, const Bounds& centres) const {
    Split best;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double low = centres.min[axis], width = centres.max[axis] - low;
      if (!(width > 0)) continue;
      std::array<Bounds, kBins> bins;
      std::array<uint32_t, kBins> counts{};
      bins.fill(kNoBounds);
      for (const uint32_t item : items) {
        const size_t bin = bin_of(centre(item)[axis], low, width);
        grow(bins[bin], boxes[item]), ++counts[bin];
      }
      std::array<double, kBins> right_cost{};
      Bounds side = kNoBounds;
      uint32_t count = 0;
      for (size_t k = kBins - 1; k > 0; --k) {
        grow(side, bins[k]), count += counts[k];
        right_cost[k] = count == 0 ? 0 : half_area(side) * count;
      }
      side = kNoBounds, count = 0;
      for (size_t k = 1; k < kBins; ++k) {
        grow(side, bins[k - 1]), count += counts[k - 1];
        const double cost = (count == 0 ? 0 : half_area(side) * count) + right_cost[k];
        if (count > 0 && count < items.size() && cost < least)
          least = cost, best = {axis, low + width * static_cast<double>(k) / kBins};
      }
    }
    return best;
  }
  static size_t bin_of(double at, double low, double width) {
    return static_cast<size_t>(std::clamp((at - low) / width * kBins, 0.0, kBins - 1.0));
  }
};

Bvh::Bvh(std::span<const Bounds> boxes) {
  if (boxes.empty()) return;
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0u);
  Build build{boxes};
  add(build, 0, static_cast<uint32_t>(boxes.size()), 0);
}

// The items from `begin` up to `end` as a node; its index.
uint32_t Bvh::add(Build& build, uint32_t begin, uint32_t end, size_t depth) {
  const auto index = static_cast<uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Bounds box = kNoBounds, centres = kNoBounds;
  for (uint32_t i = begin; i < end; ++i) {
    const glm::dvec3 centre = build.centre(items_[i]);
    grow(box, build.boxes[items_[i]]), include(centres, centre);
  }
  nodes_[index].box = padded(box);
  const std::span<const uint32_t> items(items_.data() + begin, end - begin);
  if (items.size() <= kLeaf) {
    nodes_[index].first = begin, nodes_[index].count = end - begin;
    return index;
  }
  const Build::Split split = depth < kDeep ? build.best_split(items, centres) : Build::Split{};
  uint32_t middle = begin + (end - begin) / 2;
  int axis = std::max(split.axis, 0);
  if (split.axis >= 0)
    middle = static_cast<uint32_t>(std::partition(items_.begin() + begin, items_.begin() + end,
                                                  [&](uint32_t i) { return build.centre(i)[axis] < split.at; }) -
                                   items_.begin());
  if (middle == begin || middle == end) {  // all in one place, or told apart by rounding only
    middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](uint32_t a, uint32_t b) { return build.centre(a)[axis] < build.centre(b)[axis]; });
  }
  const uint32_t first = add(build, begin, middle, depth + 1), second = add(build, middle, end, depth + 1);
  nodes_[index].first = first, nodes_[index].second = second, nodes_[index].axis = axis;
  return index;
}

}  // namespace gbl
