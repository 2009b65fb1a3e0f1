#include "renderer/light/cluster_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/base/threads.h"
#include "renderer/light/light_volume.h"

namespace gbl {
namespace {

// Added to a radius, relative to it and to the distance: positions and slices are computed in float on the GPU.
constexpr double kFloatSlack = 1e-5;

// What is nearer than this part of the farthest light is one slice: a tiny pyramid of space, in which few lights meet.
// With slices down to the near plane, most of them would lie in a hand's breadth of air.
constexpr double kNearestPart = 0.03;

// A light is tested as often as it should be only if it is a few tiles wide. Smaller tiles than these cost more than they spare.
constexpr int kSmallTile = kBlock, kTile = 16, kLargestTile = 256;
constexpr double kWideLight = 5;  // … times kTile, as the mean of those in view

// Above so many pairs of a light and a tile under its outline, tiles are made larger: it is these that listing takes its
// time for. Lights that overlap so many tiles are wide, so that little is lost.
constexpr double kMostVisits = 2e6;

struct View {
  View(const Camera& c, double aspect, const PositionStep& s)
      : camera(c), step(s), half(c.half_height(aspect) * glm::dvec2(aspect, 1)) {}

  // Does the ball hold all that can be seen?
  bool inside(const glm::dvec3& centre, double radius) const {
    const double widest = camera.orthographic() ? 1 : camera.far;
    if (radius < widest * half.x) return false;
    for (const double depth : {camera.near, camera.far})
      for (const double x : {-half.x, half.x})
        for (const double y : {-half.y, half.y}) {
          const double width = camera.orthographic() ? 1 : depth;
          if (glm::distance(centre, {x * width, y * width, depth}) >= radius) return false;
        }
    return true;
  }

  const Camera& camera;
  const PositionStep& step;
  glm::dvec2 half;  // extents of the picture
};

// By what arithmetic in float and the stored positions may be off.
Ball widened(const View& view, const Light& light) {
  const Ball ball = reach_of(light);
  const double distance = glm::distance(ball.centre, view.camera.position), radius = ball.radius;
  const glm::dvec3 along = glm::abs(ball.centre);
  const double coordinate = std::max({along.x, along.y, along.z}) + radius;
  return {ball.centre, radius * (1 + kFloatSlack) + distance * kFloatSlack +
                           (distance + radius) * view.step.of_distance + coordinate * view.step.of_coordinate +
                           view.step.world};
}

// False if nothing of it can be in view.
bool find_pixels(const View& view, glm::ivec2 size, LightReach& r) {
  const ScreenBounds b = clipped(view_bounds(view.camera, view.half, r.centre, r.radius));
  if (b.empty() || r.centre.z - r.radius > view.camera.far) return false;
  r.first_pixel = glm::min(glm::ivec2((b.from + 1.0) / 2.0 * glm::dvec2(size)), size - 1);
  r.last_pixel = glm::min(glm::ivec2((b.to + 1.0) / 2.0 * glm::dvec2(size)), size - 1);
  return true;
}

// Some of the lights, which one thread works on.
struct Share {
  std::vector<LightReach> reaches;
  std::vector<uint32_t> everywhere;
};

void find_lights(const View& view, glm::ivec2 size, std::span<const Light> lights, size_t first, size_t end,
                 Share& out) {
  for (size_t i = first; i < end; ++i) {
    LightReach r{.light = static_cast<uint32_t>(i)};
    if (bounded(lights[i])) {
      const Ball ball = widened(view, lights[i]);
      r.centre = view_of(view.camera, ball.centre), r.radius = ball.radius;
    }
    if (!bounded(lights[i]) || view.inside(r.centre, r.radius))
      out.everywhere.push_back(r.light);
    else if (find_pixels(view, size, r))
      out.reaches.push_back(r);
  }
}

void find_lights(const View& view, glm::ivec2 size, std::span<const Light> lights, ClusterGrid& grid) {
  constexpr size_t kWorthAThread = 1000;  // lights: a thread starts in the time that so many take
  const size_t count = std::clamp<size_t>(lights.size() / kWorthAThread, 1, static_cast<size_t>(all_processors()));
  std::vector<Share> shares(count);
  on_threads(static_cast<int>(count), [&](int k) {
    const auto i = static_cast<size_t>(k);
    find_lights(view, size, lights, lights.size() * i / count, lights.size() * (i + 1) / count, shares[i]);
  });
  for (const Share& s : shares) {
    grid.reaches.insert(grid.reaches.end(), s.reaches.begin(), s.reaches.end());
    grid.everywhere.insert(grid.everywhere.end(), s.everywhere.begin(), s.everywhere.end());
  }
}

// Looking at depths takes as long as some tests per pixel (bench, hall, llvmpipe; a GPU's wait is longer). It saves at most one for
// each pixel that a light covers.
constexpr double kLookingTakes = 3;

double covered_pixels(const ClusterGrid& grid) {
  double sum = 0;
  for (const LightReach& r : grid.reaches) {
    const glm::dvec2 pixels = r.last_pixel - r.first_pixel + 1;
    sum += pixels.x * pixels.y;
  }
  return sum;
}

int slices_for(int tile, bool looks) {
  constexpr int kUnseen = 8;  // each stands in each tile
  return looks ? std::min(kMostSlices, kMostSlices * kTile / tile) : kUnseen;
}

// From the nearest to the farthest point that any light reaches: elsewhere no list is needed.
void find_slices(const Camera& camera, ClusterGrid& grid) {
  double nearest = camera.far, farthest = camera.near;
  for (const LightReach& r : grid.reaches) {
    nearest = std::min(nearest, r.centre.z - r.radius);
    farthest = std::max(farthest, r.centre.z + r.radius);
  }
  farthest = std::min(farthest, camera.far);
  nearest = std::max({nearest, camera.near, farthest * kNearestPart});
  const double octaves = std::max(1.0, std::log2(farthest / nearest));
  grid.slices = slices_for(grid.tile_px, grid.looks);
  grid.slice_scale = grid.slices / octaves;
  grid.slice_offset = -std::log2(nearest) * grid.slice_scale;
  grid.slice_edges.assign(1, 0.0f);
  for (int k = 1; k < grid.slices; ++k)
    grid.slice_edges.push_back(static_cast<float>(std::exp2((k - grid.slice_offset) / grid.slice_scale)));
  // Where a light reaches on beyond the far plane, so does the last slice: a depth may be rounded to that side.
  const bool beyond = farthest >= camera.far;
  grid.slice_edges.push_back(beyond ? std::numeric_limits<float>::max()
                                    : static_cast<float>(farthest * (1 + kFloatSlack)));
  const auto slice_of = [&](double depth) {
    return depth > nearest ? std::min(grid.slices - 1, static_cast<int>(std::log2(depth / nearest) * grid.slice_scale))
                           : 0;
  };
  for (LightReach& r : grid.reaches) {
    // One to either side: where float arithmetic may see a border.
    const int first = std::max(0, slice_of(r.centre.z - r.radius) - 1);
    const int last = std::min(kMostSlices - 1, slice_of(r.centre.z + r.radius) + 1);
    for (int k = first; k <= last; ++k) r.slices |= uint64_t{1} << k;
  }
}

double visits(const ClusterGrid& grid, int tile) {
  double sum = 0;
  for (const LightReach& r : grid.reaches) {
    const glm::dvec2 tiles = r.last_pixel / tile - r.first_pixel / tile + 1;
    sum += tiles.x * tiles.y;
  }
  return sum;
}

// Of what is seen of it, the larger of width and height.
double mean_light_px(const ClusterGrid& grid) {
  double sum = 0;
  for (const LightReach& r : grid.reaches)
    sum += std::max(r.last_pixel.x - r.first_pixel.x, r.last_pixel.y - r.first_pixel.y) + 1;
  return grid.reaches.empty() ? 0 : sum / double(grid.reaches.size());
}

size_t heads(glm::ivec2 size, int tile, bool looks) {
  const glm::ivec2 tiles = (size + tile - 1) / tile;
  return static_cast<size_t>(tiles.x) * static_cast<size_t>(tiles.y) * static_cast<size_t>(1 + slices_for(tile, looks));
}

int tile_for(const ClusterGrid& grid, glm::ivec2 size, size_t most_heads) {
  int tile = grid.light_px < kWideLight * kTile ? kSmallTile : kTile;
  while (tile < kLargestTile && (visits(grid, tile) > kMostVisits || heads(size, tile, grid.looks) > most_heads))
    tile *= 2;
  return tile;
}

std::vector<float> edges(int cells, int tile, int pixels, double half) {
  std::vector<float> out;
  for (int i = 0; i <= cells; ++i) out.push_back(static_cast<float>((2.0 * i * tile / pixels - 1) * half));
  return out;
}

}  // namespace

ClusterGrid cut_for(const Camera& camera, glm::ivec2 size, std::span<const Light> lights, const PositionStep& step,
                    size_t most_heads) {
  const View view(camera, double(size.x) / size.y, step);
  ClusterGrid grid{.orthographic = camera.orthographic(), .light_count = static_cast<uint32_t>(lights.size())};
  find_lights(view, size, lights, grid);
  grid.light_px = mean_light_px(grid);
  grid.looks = covered_pixels(grid) > kLookingTakes * size.x * size.y;
  grid.tile_px = grid.reaches.empty() ? kLargestTile : tile_for(grid, size, most_heads);
  find_slices(camera, grid);
  grid.tiles = (size + grid.tile_px - 1) / grid.tile_px;
  grid.blocks = (size + kBlock - 1) / kBlock;
  grid.column_edges = edges(grid.tiles.x, grid.tile_px, size.x, view.half.x);
  grid.row_edges = edges(grid.tiles.y, grid.tile_px, size.y, view.half.y);
  return grid;
}

}  // namespace gbl
