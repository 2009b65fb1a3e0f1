#pragma once
// The view cut into columns, rows and slices, the slices logarithmic in depth, and for each of these clusters the
// lights that reach into it. A cluster's list holds every light that reaches any of its points; clusters leave no gap.
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace gbl {

inline constexpr glm::ivec3 kClusters{32, 18, 24};
inline constexpr int kClusterCount = kClusters.x * kClusters.y * kClusters.z;

// No more entries in all lists together than this (32 MiB). A light beyond it is not dropped: everywhere() takes it.
inline constexpr uint32_t kMostClusterEntries = 1u << 23;

class LightClusters {
 public:
  // A pure function of its arguments; only the memory of the build before is used again.
  void build(const Camera&, double aspect, std::span<const Light>, uint32_t most_entries = kMostClusterEntries);

  // What the shader reads, in texels of four words: per cluster one of them, with the texel where its list starts and how
  // long it is; then the lists, each in the lights' own order and filled up with the number of lights.
  std::span<const uint32_t> words() const { return words_; }
  std::span<const uint32_t> list(int cluster) const;

  // The list that every pixel reads beside its cluster's: lights without end, lights that reach more than half of the
  // clusters, and the widest of the others while the lists together would be too long.
  std::span<const uint32_t> everywhere() const { return everywhere_; }
  uint32_t everywhere_texel() const { return everywhere_texel_; }

  // slice = floor(log2(depth) * slice_scale + slice_offset), held within 0 … kClusters.z - 1.
  double slice_scale() const { return slice_scale_; }
  double slice_offset() const { return slice_offset_; }

  // Index of the cluster of a point on screen: the arithmetic of shaders/light_clustered.frag.
  int cluster_at(glm::dvec2 ndc, double depth) const;

 private:
  struct Cells {  // columns first … last of one row of one slice
    uint16_t row;
    uint8_t first, last;
  };
  struct Listed {  // a light with its part of cells_
    uint32_t light, begin, end, entries;
  };
  class View;

  void find_slices(const View&, std::span<const Light>);
  bool find_cells(const View&, const glm::dvec3& centre, double radius);
  void add(const View&, const Light&, uint32_t index);
  void keep_within(uint32_t most_entries);
  void fill(uint32_t no_light);

  double slice_scale_ = 0, slice_offset_ = 0;
  uint32_t everywhere_texel_ = 0;
  std::vector<double> slice_starts_;
  std::vector<Cells> cells_;
  std::vector<Listed> listed_;
  std::vector<uint32_t> everywhere_, words_;
};

}  // namespace gbl
