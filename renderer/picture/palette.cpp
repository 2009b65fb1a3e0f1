#include "renderer/picture/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gbl {
namespace {

constexpr size_t kMostColours = 256;
constexpr unsigned kDropped = 2;  // low bits of a channel that the cutting does not look at
constexpr size_t kCoarseColours = size_t(1) << 3 * (8 - kDropped);
constexpr float kMostOwed = 32;  // codes: a colour that the palette has nothing near to leaves no trail

// All pixels of one coarse colour.
struct Bin {
  std::array<uint64_t, 3> sum{};
  uint64_t count = 0;
  double mean(size_t k) const { return double(sum[k]) / double(count); }
};

using Bins = std::vector<Bin*>;

size_t coarse(const uint8_t* rgb) {
  return (size_t(rgb[0] >> kDropped) << 12) | (size_t(rgb[1] >> kDropped) << 6) | size_t(rgb[2] >> kDropped);
}

// Bins that will share a colour.
struct Box {
  Bins bins;
  size_t longest = 0;  // channel
  double weight = 0;   // how much there is to gain by cutting it

  explicit Box(Bins all) : bins(std::move(all)) {
    double most = 0;
    uint64_t count = 0;
    for (const Bin* b : bins) count += b->count;
    for (size_t k = 0; k < 3; ++k) {
      const auto by = [k](const Bin* a, const Bin* b) { return a->mean(k) < b->mean(k); };
      const auto [low, high] = std::minmax_element(bins.begin(), bins.end(), by);
      const double extent = (*high)->mean(k) - (*low)->mean(k);
      if (extent > most) most = extent, longest = k;
    }
    weight = most * std::pow(double(count), 0.15);  // a colour that is far off counts, however few pixels have it
  }

  // Into two of half the extent.
  std::pair<Bins, Bins> cut() {
    std::sort(bins.begin(), bins.end(),
              [this](const Bin* a, const Bin* b) { return a->mean(longest) < b->mean(longest); });
    const double middle = (bins.front()->mean(longest) + bins.back()->mean(longest)) / 2;
    auto at = bins.begin() + 1;
    while (at + 1 != bins.end() && (*at)->mean(longest) < middle) ++at;
    return {Bins(bins.begin(), at), Bins(at, bins.end())};
  }

  std::array<uint8_t, 3> colour() const {
    std::array<double, 3> sum{};
    double count = 0;
    for (const Bin* b : bins) {
      count += double(b->count);
      for (size_t k = 0; k < 3; ++k) sum[k] += double(b->sum[k]);
    }
    std::array<uint8_t, 3> out{};
    for (size_t k = 0; k < 3; ++k) out[k] = static_cast<uint8_t>(std::lround(sum[k] / count));
    return out;
  }
};

std::vector<std::array<uint8_t, 3>> palette_of(const Image& image) {
  std::vector<Bin> bins(kCoarseColours);
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    Bin& b = bins[coarse(&image.rgba[i])];
    ++b.count;
    for (size_t k = 0; k < 3; ++k) b.sum[k] += image.rgba[i + k];
  }
  Bins used;
  for (Bin& b : bins)
    if (b.count > 0) used.push_back(&b);
  std::vector<Box> boxes;
  if (!used.empty()) boxes.emplace_back(std::move(used));
  while (boxes.size() < kMostColours) {
    const auto next =
        std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.weight < b.weight; });
    if (next == boxes.end() || next->bins.size() < 2) break;
    auto [low, high] = next->cut();
    *next = Box(std::move(low));
    boxes.emplace_back(std::move(high));
  }
  std::vector<std::array<uint8_t, 3>> palette;
  for (const Box& b : boxes) palette.push_back(b.colour());
  return palette;
}

// The nearest of a palette; of colours that are seen often it is looked up.
class Nearest {
 public:
  explicit Nearest(const std::vector<std::array<uint8_t, 3>>& palette)
      : palette_(palette), known_(kCoarseColours, -1) {}
  size_t of(const std::array<float, 3>& colour) {
    std::array<uint8_t, 3> code{};
    for (size_t k = 0; k < 3; ++k) code[k] = static_cast<uint8_t>(std::lround(std::clamp(colour[k], 0.0f, 255.0f)));
    const bool exact = std::binary_search(sorted_.begin(), sorted_.end(), code);
    int& known = known_[coarse(code.data())];
    if (!exact && known >= 0) return static_cast<size_t>(known);
    const size_t found = search(code);
    if (!exact) known = static_cast<int>(found);
    return found;
  }

 private:
  size_t search(const std::array<uint8_t, 3>& code) const {
    size_t best = 0;
    int least = std::numeric_limits<int>::max();
    for (size_t i = 0; i < palette_.size(); ++i) {
      int off = 0;
      for (size_t k = 0; k < 3; ++k) off += (code[k] - palette_[i][k]) * (code[k] - palette_[i][k]);
      if (off < least) least = off, best = i;
    }
    return best;
  }

  const std::vector<std::array<uint8_t, 3>>& palette_;
  std::vector<std::array<uint8_t, 3>> sorted_ = [this] {
    auto sorted = palette_;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }();
  std::vector<int> known_;
};

}  // namespace

IndexedImage indexed(const Image& image) {
  IndexedImage out{image.size, palette_of(image), std::vector<uint8_t>(image.rgba.size() / 4)};
  Nearest nearest(out.palette);
  const auto width = static_cast<size_t>(image.size.x);
  std::vector<std::array<float, 3>> here(width + 2), below(width + 2);  // what neighbours owe, one to the right
  for (size_t y = 0; y < static_cast<size_t>(image.size.y);
       ++y, std::swap(here, below), std::fill(below.begin(), below.end(), std::array<float, 3>{}))
    for (size_t x = 0; x < width; ++x) {
      std::array<float, 3> wanted{};
      for (size_t k = 0; k < 3; ++k) wanted[k] = float(image.rgba[4 * (y * width + x) + k]) + here[x + 1][k];
      const size_t index = nearest.of(wanted);
      out.index[y * width + x] = static_cast<uint8_t>(index);
      for (size_t k = 0; k < 3; ++k) {
        const float owed = std::clamp(wanted[k] - float(out.palette[index][k]), -kMostOwed, kMostOwed);
        here[x + 2][k] += owed * 7 / 16;
        below[x][k] += owed * 3 / 16, below[x + 1][k] += owed * 5 / 16, below[x + 2][k] += owed / 16;
      }
    }
  return out;
}

Image expanded(const IndexedImage& few) {
  Image out{few.size, {}};
  for (const uint8_t i : few.index)
    out.rgba.insert(out.rgba.end(), {few.palette[i][0], few.palette[i][1], few.palette[i][2], 255});
  return out;
}

}  // namespace gbl
