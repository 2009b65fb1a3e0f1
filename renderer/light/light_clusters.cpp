#include "renderer/light/light_clusters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "renderer/base/threads.h"

namespace gbl {
namespace {

constexpr uint32_t kTexel = 4;  // words

// Of a slice: what is so close to a border belongs to both sides, since the shader rounds otherwise.
constexpr float kBorder = 1e-3f;

// Four numbers side by side (an extension that GCC and Clang share).
using Four = float __attribute__((vector_size(16)));
Four smaller(Four a, Four b) { return a < b ? a : b; }
Four larger(Four a, Four b) { return a > b ? a : b; }

// Does a ball meet what is seen of some clusters? Four are asked at a time. Floats are good enough: the balls are wider
// than they must be (cluster_grid.cpp).
class Meetings {
 public:
  static constexpr size_t kAtOnce = 4;

  Meetings(const LightReach& r, bool orthographic)
      : centre_(r.centre), squared_(static_cast<float>(r.radius * r.radius)), turn_(orthographic ? 0.0f : 1.0f) {}

  // Of each of a tile's borders: a slope, or a place if orthographic.
  struct Asked {
    Four left, right, low, high, nearest, farthest;
  };

  // The squared distance is convex in depth, and of pieces that are quadratic. So the lowest point of the piece at the
  // centre's depth is the lowest of all, or the tangent there bounds what is nearer.
  Four least_squared(const Asked& c) const {
    const Four first = smaller(larger(Four{} + centre_.z, c.nearest), c.farthest);
    Aside x = aside(centre_.x, c.left, c.right, first), y = aside(centre_.y, c.low, c.high, first);
    const Four bent = 1 + x.slope * x.slope + y.slope * y.slope;
    const Four lowest = first + (centre_.z - first - x.slope * x.gap - y.slope * y.gap) / bent;
    const Four depth = smaller(larger(lowest, c.nearest), c.farthest), along = depth - centre_.z;
    x = aside(centre_.x, c.left, c.right, depth), y = aside(centre_.y, c.low, c.high, depth);
    const Four steepness = 2 * (along + x.slope * x.gap + y.slope * y.gap);
    const Four nearer = smaller(steepness * (c.nearest - depth), steepness * (c.farthest - depth));
    return along * along + x.gap * x.gap + y.gap * y.gap + smaller(nearer, Four{});
  }
  float squared() const { return squared_; }

 private:
  // What one axis adds: how far the centre is beyond a border, and how that border moves with depth. 0 within.
  struct Aside {
    Four gap, slope;
  };
  Aside aside(float centre, Four from, Four to, Four depth) const {
    const Four width = turn_ * depth + (1 - turn_), before = from * width - centre, beyond = centre - to * width;
    const Four slope = before > 0 ? from : (beyond > 0 ? -to : Four{});
    return {larger(larger(before, beyond), Four{}), turn_ * slope};
  }

  const glm::vec3 centre_;
  const float squared_, turn_;
};

template <class Use>
void each_bit(uint64_t bits, Use use) {
  for (; bits; bits &= bits - 1) use(std::countr_zero(bits));
}

}  // namespace

void LightClusters::forget() { built_ = false; }

bool LightClusters::build(const ClusterGrid& grid, std::span<const DepthSpan> blocks, uint32_t most_entries) {
  const bool same = built_ && most_entries == most_entries_ && grid == grid_ &&
                    std::equal(blocks.begin(), blocks.end(), blocks_.begin(), blocks_.end());
  if (same) return false;
  grid_ = grid, most_entries_ = most_entries, built_ = true;
  blocks_.assign(blocks.begin(), blocks.end());
  find_clusters();
  constexpr size_t kWorthAThread = 100;  // lights: a thread starts in the time that listing so many takes
  const size_t worth = std::min(grid_.reaches.size() / kWorthAThread, static_cast<size_t>(grid_.tiles.y));
  const int bands = static_cast<int>(std::clamp<size_t>(worth, 1, static_cast<size_t>(all_processors())));
  bands_.resize(static_cast<size_t>(bands));
  on_threads(bands, [&](int i) {
    Band& band = bands_[static_cast<size_t>(i)];
    band.first_row = grid_.tiles.y * i / bands, band.end_row = grid_.tiles.y * (i + 1) / bands;
    find_entries(band);
  });
  choose_everywhere(most_entries);
  fill();
  return true;
}

void LightClusters::find_clusters() {
  tiles_.clear(), with_surfaces_.clear(), clusters_.clear();
  for (int y = 0; y < grid_.tiles.y; ++y)
    for (int x = 0; x < grid_.tiles.x; ++x) find_clusters({x, y});
}

// Each block's span is cut by the slices, and what lies in a slice is seen of the tile's cluster there.
void LightClusters::find_clusters(glm::ivec2 at) {
  Tile tile{.first_cluster = static_cast<uint32_t>(clusters_.size())};
  const int side = grid_.tile_px / kBlock;
  const glm::ivec2 first = at * side, end = glm::min(first + side, grid_.blocks);
  const auto each_span = [&](auto use) {
    for (int y = first.y; y < end.y; ++y)
      for (int x = first.x; x < end.x; ++x)
        for (size_t k = 0; k < kSpans; ++k)
          if (const DepthSpan& s = blocks_[kSpans * static_cast<size_t>(y * grid_.blocks.x + x) + k]; !s.empty())
            use(s);
  };
  DepthSpan seen;
  each_span([&](const DepthSpan& s) { seen.add(s); });
  if (!seen.empty()) {
    tile.first_slice = first_slice(seen);
    tile.slices = last_slice(seen) + 1 - tile.first_slice;
    clusters_.resize(clusters_.size() + static_cast<size_t>(tile.slices));
  }
  uint64_t with_surfaces = 0;
  each_span([&](const DepthSpan& s) {
    for (int slice = first_slice(s); slice <= last_slice(s); ++slice) {
      const auto border = [&](int k) { return std::clamp(grid_.slice_edges[k], s.nearest, s.farthest); };
      clusters_[tile.first_cluster + static_cast<size_t>(slice - tile.first_slice)].add(
          {border(slice), border(slice + 1)});
      with_surfaces |= uint64_t{1} << slice;
    }
  });
  tiles_.push_back(tile);
  with_surfaces_.push_back(with_surfaces);
}

int LightClusters::slice_at(float depth, float off) const {
  const float slice = std::log2(depth) * static_cast<float>(grid_.slice_scale) + static_cast<float>(grid_.slice_offset);
  return static_cast<int>(std::clamp(slice + off, 0.0f, static_cast<float>(grid_.slices - 1)));
}
int LightClusters::first_slice(const DepthSpan& s) const { return slice_at(s.nearest, -kBorder); }
int LightClusters::last_slice(const DepthSpan& s) const { return slice_at(s.farthest, kBorder); }

void LightClusters::find_entries(Band& band) const {
  band.count = 0;
  band.of_reach.assign(grid_.reaches.size(), 0);
  for (uint32_t i = 0; i < grid_.reaches.size(); ++i) {
    const size_t before = band.count;
    find_entries(band, i);
    band.of_reach[i] = static_cast<uint32_t>(band.count - before);
  }
}

void LightClusters::find_entries(Band& band, uint32_t reach) const {
  const LightReach& r = grid_.reaches[reach];
  const int first_row = std::max(band.first_row, r.first_pixel.y / grid_.tile_px);
  const int last_row = std::min(band.end_row - 1, r.last_pixel.y / grid_.tile_px);
  const int first_column = r.first_pixel.x / grid_.tile_px, last_column = r.last_pixel.x / grid_.tile_px;
  const Meetings ball(r, grid_.orthographic);
  Meetings::Asked asked{};
  std::array<uint32_t, Meetings::kAtOnce> clusters{};
  size_t count = 0;
  const auto ask = [&] {
    const Four least = ball.least_squared(asked);
    if (band.entries.size() < band.count + count) band.entries.resize(2 * (band.count + count));
    for (size_t k = 0; k < count; ++k) {  // without a branch: nobody can predict it
      band.entries[band.count] = {clusters[k], reach};
      band.count += least[k] < ball.squared() ? 1 : 0;
    }
    count = 0;
  };
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const size_t tile = static_cast<size_t>(row * grid_.tiles.x + column);
      each_bit(with_surfaces_[tile] & r.slices, [&](int slice) {
        const uint32_t cluster = tiles_[tile].first_cluster + static_cast<uint32_t>(slice - tiles_[tile].first_slice);
        asked.left[count] = grid_.column_edges[column], asked.right[count] = grid_.column_edges[column + 1];
        asked.low[count] = grid_.row_edges[row], asked.high[count] = grid_.row_edges[row + 1];
        asked.nearest[count] = clusters_[cluster].nearest, asked.farthest[count] = clusters_[cluster].farthest;
        clusters[count++] = cluster;
        if (count == Meetings::kAtOnce) ask();
      });
    }
  if (count > 0) ask();
}

// Those that reach nearly everything, and while there are too many entries the widest.
void LightClusters::choose_everywhere(uint32_t most_entries) {
  std::vector<uint32_t>& entries = bands_[0].of_reach;  // of all bands together, from here on
  for (size_t b = 1; b < bands_.size(); ++b)
    for (size_t i = 0; i < entries.size(); ++i) entries[i] += bands_[b].of_reach[i];
  entry_count_ = std::accumulate(entries.begin(), entries.end(), size_t{0});
  listed_.assign(entries.size(), true);
  everywhere_ = grid_.everywhere;
  const auto read_by_all = [&](size_t reach) {
    listed_[reach] = false;
    entry_count_ -= entries[reach];
    everywhere_.push_back(grid_.reaches[reach].light);
  };
  uint32_t with_surfaces = 0;
  for (const uint64_t slices : with_surfaces_) with_surfaces += static_cast<uint32_t>(std::popcount(slices));
  for (size_t i = 0; i < entries.size(); ++i)
    if (entries[i] > kNearlyAll * with_surfaces) read_by_all(i);
  if (entry_count_ > most_entries) {
    std::vector<uint32_t> widest(entries.size());
    std::iota(widest.begin(), widest.end(), 0u);
    std::stable_sort(widest.begin(), widest.end(), [&](uint32_t a, uint32_t b) { return entries[a] > entries[b]; });
    for (const uint32_t i : widest)
      if (entry_count_ > most_entries && listed_[i]) read_by_all(i);
  }
  order_everywhere();
}

void LightClusters::order_everywhere() {
  std::sort(everywhere_.begin(), everywhere_.end());
  everywhere_count_ = everywhere_.size();
  const auto first_of_last = std::stable_partition(everywhere_.begin(), everywhere_.end(), [&](uint32_t light) {
    return !std::binary_search(grid_.last.begin(), grid_.last.end(), light);
  });
  last_ones_everywhere_ = static_cast<size_t>(everywhere_.end() - first_of_last);
  if (last_ones_everywhere_ == 0) return;
  const size_t others = everywhere_.size() - last_ones_everywhere_;
  everywhere_.insert(first_of_last, (kTexel - others % kTexel) % kTexel, grid_.light_count);
}

void LightClusters::fill() {
  const uint32_t no_light = grid_.light_count;
  const uint32_t heads = static_cast<uint32_t>(tiles_.size()), clusters = static_cast<uint32_t>(clusters_.size());
  uint32_t texel = heads + clusters;
  words_.assign(kTexel * texel, 0);
  for (uint32_t t = 0; t < heads; ++t) {
    words_[kTexel * t] = heads + tiles_[t].first_cluster;
    words_[kTexel * t + 1] = static_cast<uint32_t>(tiles_[t].first_slice);
    words_[kTexel * t + 2] = static_cast<uint32_t>(tiles_[t].slices);
  }
  // No two bands have a cluster in common.
  const auto each_entry = [&](auto use) {
    on_threads(static_cast<int>(bands_.size()), [&](int band) {
      for (const Entry& e : bands_[static_cast<size_t>(band)].found())
        if (listed_[e.reach]) use(kTexel * (heads + e.cluster), grid_.reaches[e.reach].light);
    });
  };
  each_entry([&](uint32_t head, uint32_t) { ++words_[head + 1]; });
  const auto take = [&](size_t words) {
    return std::exchange(texel, texel + (static_cast<uint32_t>(words) + kTexel - 1) / kTexel);
  };
  for (uint32_t head = kTexel * heads; head < kTexel * (heads + clusters); head += kTexel)
    words_[head] = take(words_[head + 1]), words_[head + 2] = kTexel * words_[head];  // 2: where the next entry goes
  everywhere_texel_ = take(everywhere_.size());
  words_.resize(kTexel * texel, no_light);
  each_entry([&](uint32_t head, uint32_t light) { words_[words_[head + 2]++] = light; });
  std::copy(everywhere_.begin(), everywhere_.end(), words_.begin() + kTexel * everywhere_texel_);
}

std::span<const uint32_t> LightClusters::list(glm::ivec2 tile, int slice) const {
  const Tile& t = tiles_[static_cast<size_t>(tile.y * grid_.tiles.x + tile.x)];
  if (slice < t.first_slice || slice >= t.first_slice + t.slices) return {};
  const size_t head = kTexel * (tiles_.size() + t.first_cluster + static_cast<size_t>(slice - t.first_slice));
  return words().subspan(kTexel * words_[head], words_[head + 1]);
}

}  // namespace gbl
