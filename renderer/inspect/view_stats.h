#pragma once
// What the numbers of a view are like, from some tens of thousands of its pixels: ranges, histogram, what is unsound.
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace gbl {

// Which pixels of a picture are asked: every step-th from the first, origin top left.
struct PixelGrid {
  glm::ivec2 first{0}, step{1}, count{0};
  size_t pixels() const { return static_cast<size_t>(count.x) * static_cast<size_t>(count.y); }
  bool operator==(const PixelGrid&) const = default;
};
// All of a picture, thinned out to 65 536 pixels at most: reading so many back costs less than a millisecond.
PixelGrid sample_grid(glm::ivec2 size);

struct ViewStats {
  static constexpr int kBins = 64;
  size_t pixels = 0;                                  // that have numbers
  size_t nonfinite = 0, negative = 0;                 // pixels with such a channel
  glm::dvec3 min{0}, max{0}, mean{0};                 // of the finite numbers
  glm::dvec2 binned{0, 1};                            // what the histogram spans: least to largest number
  std::array<std::array<uint32_t, kBins>, 3> bins{};  // pixels by channel
  std::array<size_t, 8> whole{};                      // pixels whose first number rounds to 0 … 7
  double marked() const { return pixels == 0 ? 0 : 1 - double(whole[0]) / double(pixels); }  // share that is not 0
  double largest() const { return std::max({max.x, max.y, max.z}); }
};
// values: xyz, and w > 0.5 where a pixel has numbers.
ViewStats view_stats(std::span<const glm::vec4> values, int components);

// Black and white that hold all numbers of these channels (a subset of "rgb"): round ones.
glm::dvec2 fitted_range(const ViewStats&, int components, std::string_view channels);

// A bar from a round number at or below `least` to one at or above `most`, with round quarters.
glm::dvec2 round_range(double least, double most);

}  // namespace gbl
