#pragma once
// For each cluster with surfaces in it, the lights that reach into it. Olsson, Billeter and Assarsson 2012, "Clustered
// Deferred and Forward Shading": what holds no surface needs no list, and what does is no larger than its surfaces.
// A list holds every light that reaches any point that is seen of its cluster, but for those that every pixel reads.
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/light/cluster_grid.h"

namespace gbl {

// No more entries in all lists together than this (16 MiB). A light beyond it is not dropped: everywhere() takes it.
inline constexpr uint32_t kMostClusterEntries = 1u << 22;

// A light that reaches more of the clusters than this is read by all: the few pixels that could have done without it cost
// less than its lists.
inline constexpr double kNearlyAll = 0.875;

class LightClusters {
 public:
  // A pure function of its arguments; only the memory of the build before is used again. `blocks`: what is seen of the
  // picture's blocks, row by row from the bottom, kSpans of each. False if nothing has changed since the build before.
  bool build(const ClusterGrid&, std::span<const DepthSpan> blocks, uint32_t most_entries = kMostClusterEntries);
  void forget();  // the next build changes everything

  // What the shader reads, in texels of four words: per tile one of them, with the texel of its first cluster, that one's
  // slice and how many slices follow it; per cluster one, with the texel where its list starts and how long it is; then the lists, each
  // in the lights' own order and filled up with `no_light`.
  std::span<const uint32_t> words() const { return words_; }
  size_t cluster_count() const { return clusters_.size(); }
  std::span<const uint32_t> list(glm::ivec2 tile, int slice) const;  // empty where no surface was said to be
  size_t entry_count() const { return entry_count_; }

  // The list that every pixel reads beside its cluster's: the grid's, lights that reach nearly all of the clusters, and
  // the widest of the others while the lists together would be too long.
  // Where some of grid().last are among them, these stand at the end, from a whole texel on.
  std::span<const uint32_t> everywhere() const { return everywhere_; }
  size_t everywhere_count() const { return everywhere_count_; }  // of lights
  size_t last_ones_everywhere() const { return last_ones_everywhere_; }
  uint32_t everywhere_texel() const { return everywhere_texel_; }

  const ClusterGrid& grid() const { return grid_; }

 private:
  struct Tile {
    uint32_t first_cluster = 0;
    int first_slice = 0, slices = 0;
  };
  struct Entry {
    uint32_t cluster, reach;  // index into grid_.reaches
  };
  // Some rows of tiles, which one thread works on.
  struct Band {
    int first_row = 0, end_row = 0;
    std::vector<Entry> entries;  // the first `count`; the rest is room
    size_t count = 0;
    std::vector<uint32_t> of_reach;  // how many entries each has
    std::span<const Entry> found() const { return std::span(entries).first(count); }
  };

  void find_clusters();
  void find_clusters(glm::ivec2 tile);
  int slice_at(float depth, float off) const;
  int first_slice(const DepthSpan&) const;
  int last_slice(const DepthSpan&) const;
  void find_entries(Band&) const;
  void find_entries(Band&, uint32_t reach) const;
  void choose_everywhere(uint32_t most_entries);
  void order_everywhere();
  void fill();

  ClusterGrid grid_;
  std::vector<DepthSpan> blocks_;
  uint32_t most_entries_ = 0;
  bool built_ = false;

  std::vector<Tile> tiles_;
  std::vector<uint64_t> with_surfaces_;  // of each tile, a bit for each slice
  std::vector<DepthSpan> clusters_;
  uint32_t everywhere_texel_ = 0;
  size_t entry_count_ = 0;
  std::vector<Band> bands_;
  std::vector<char> listed_;  // of each reach
  std::vector<uint32_t> everywhere_, words_;
  size_t everywhere_count_ = 0, last_ones_everywhere_ = 0;
};

}  // namespace gbl
