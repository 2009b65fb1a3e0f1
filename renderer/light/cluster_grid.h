#pragma once
// How the picture and its depth are cut into clusters for a set of lights: square tiles of pixels, and slices that are
// logarithmic in depth. Also what is known of their surfaces.
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "renderer/light/light_bounds.h"

namespace gbl {

inline constexpr int kMostSlices = 64;
inline constexpr int kSpans = 2;  // of a block
inline constexpr int kBlock = 8;  // pixels a side of what is looked at for depths; tiles are one block or more

// Between which depths along the view axis surfaces lie, in world units.
struct DepthSpan {
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;  // nearest > farthest: there are none
  bool empty() const { return nearest > farthest; }
  void add(const DepthSpan& s) { nearest = std::min(nearest, s.nearest), farthest = std::max(farthest, s.farthest); }
  bool operator==(const DepthSpan&) const = default;
};

// A light with an end, as the camera sees it: the ball of its reach, its pixels and its slices, first and last.
struct LightReach {
  uint32_t light = 0;
  glm::dvec3 centre{0};  // right, up, depth
  double radius = 0;
  glm::ivec2 first_pixel{0}, last_pixel{0};  // origin bottom left
  uint64_t slices = 0;
  bool operator==(const LightReach&) const = default;
};

struct ClusterGrid {
  int tile_px = 0;
  double light_px = 0;  // a light's width or height, the mean of those in view
  // Is it worth the wait to find out where surfaces are? Else lists are of few, whole clusters.
  bool looks = false;
  glm::ivec2 tiles{0}, blocks{0};  // columns, rows; the last may stick out of the picture
  int slices = 0;                  // as many as keep a cluster's shape, so fewer with larger tiles
  // slice = floor(log2(depth) * slice_scale + slice_offset). What is nearer than the first belongs to it, what is farther
  // than the last to that.
  double slice_scale = 0, slice_offset = 0;
  bool orthographic = false;
  // Borders, one more than there are cells. Of tiles as slopes: times the depth, or as they are if orthographic.
  std::vector<float> column_edges, row_edges, slice_edges;

  uint32_t light_count = 0;          // of all lights
  std::vector<LightReach> reaches;   // of those that reach something in view, in the lights' order
  std::vector<uint32_t> everywhere;  // lights that reach all that can be in view, or have no end

  std::vector<uint32_t> last;  // lights that stand after the others where all are read, ascending

  bool operator==(const ClusterGrid&) const = default;
  int tile_count() const { return tiles.x * tiles.y; }
  float end_of_reach() const { return slice_edges.back(); }
};

// How far a position that is stored or worked out may be off the ray of its pixel.
struct PositionStep {
  double of_distance = 0;    // from the camera
  double of_coordinate = 0;  // in the world
  double world = 0;          // units
};

// most_heads: no more tiles and clusters together.
ClusterGrid cut_for(const Camera&, glm::ivec2 size_px, std::span<const Light>, const PositionStep& = {},
                    size_t most_heads = std::numeric_limits<size_t>::max());

}  // namespace gbl
