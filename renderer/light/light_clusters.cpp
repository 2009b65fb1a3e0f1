#include "renderer/light/light_clusters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/light/light_bounds.h"
#include "renderer/light/light_volume.h"

namespace gbl {
namespace {

// Added to a radius, relative to it and to the distance: positions and slices are computed in float on the GPU.
constexpr double kFloatSlack = 1e-5;

// What is nearer than this part of the farthest light is one slice: a tiny pyramid of space, in which few lights meet.
// With slices down to the near plane, most of them would lie in a hand's breadth of air.
constexpr double kNearestPart = 0.01;

}  // namespace

// The camera in view coordinates: right, up, and depth along the view axis.
class LightClusters::View {
 public:
  View(const Camera& c, double aspect)
      : camera(c), half_height_(c.half_height(aspect)), half_width_(half_height_ * aspect) {}

  // Columns or rows, in normalised device coordinates, of the part of a ball at depth >= nearest.
  Interval across(double right, double depth, double radius, double nearest) const {
    return extent(right, depth, radius, nearest, half_width_);
  }
  Interval along(double up, double depth, double radius, double nearest) const {
    return extent(up, depth, radius, nearest, half_height_);
  }

  // How far a point is above the plane between two rows, and the point moved down onto it.
  double above(const glm::dvec3& p, double ndc) const {
    const double slope = ndc * half_height_;
    return camera.orthographic() ? p.y - slope : (p.y - slope * p.z) / std::sqrt(1 + slope * slope);
  }
  glm::dvec3 moved_down(const glm::dvec3& p, double by, double ndc) const {
    if (camera.orthographic()) return p - glm::dvec3(0, by, 0);
    const double slope = ndc * half_height_;
    return p - by / std::sqrt(1 + slope * slope) * glm::dvec3(0, 1, -slope);
  }

  // Does the ball hold all that can be seen?
  bool inside(const glm::dvec3& centre, double radius) const {
    for (const double depth : {camera.near, camera.far})
      for (const double x : {-half_width_, half_width_})
        for (const double y : {-half_height_, half_height_}) {
          const double width = camera.orthographic() ? 1 : depth;
          if (glm::distance(centre, {x * width, y * width, depth}) >= radius) return false;
        }
    return true;
  }

  const Camera& camera;

 private:
  Interval extent(double c, double depth, double radius, double nearest, double half) const {
    if (camera.orthographic()) return {(c - radius) / half, (c + radius) / half};
    const Interval slopes = slopes_of_circle(c, depth, radius, nearest);
    return {slopes.from / half, slopes.to / half};
  }
  double half_height_, half_width_;
};

namespace {

// First and last of `count` equal parts of -1 … 1 that an interval touches; empty where it is beside all of them.
struct Parts {
  int first = 0, last = -1;
};
Parts parts_of(const Interval& ndc, int count) {
  if (ndc.empty() || ndc.to < -1 || ndc.from > 1) return {};
  const auto part = [&](double x) { return std::clamp(static_cast<int>((x + 1) / 2 * count), 0, count - 1); };
  return {part(std::max(ndc.from, -1.0)), part(std::min(ndc.to, 1.0))};
}

double ndc_of(int border, int count) { return 2.0 * border / count - 1; }

Ball widened(const Camera& camera, const Light& light) {
  const Ball ball = reach_of(light);
  const double distance = glm::distance(ball.centre, camera.position);
  return {ball.centre, ball.radius * (1 + kFloatSlack) + distance * kFloatSlack};
}

}  // namespace

void LightClusters::build(const Camera& camera, double aspect, std::span<const Light> lights, uint32_t most_entries) {
  const View view(camera, aspect);
  cells_.clear(), listed_.clear(), everywhere_.clear();
  find_slices(view, lights);
  for (size_t i = 0; i < lights.size(); ++i) add(view, lights[i], static_cast<uint32_t>(i));
  keep_within(most_entries);
  fill(static_cast<uint32_t>(lights.size()));
}

// From the nearest to the farthest point that any light reaches: elsewhere no list is needed.
void LightClusters::find_slices(const View& view, std::span<const Light> lights) {
  const Camera& camera = view.camera;
  double nearest = camera.far, farthest = camera.near;
  for (const Light& l : lights) {
    if (!bounded(l)) continue;
    const Ball ball = widened(camera, l);
    const double depth = view_of(camera, ball.centre).z;
    nearest = std::min(nearest, depth - ball.radius);
    farthest = std::max(farthest, depth + ball.radius);
  }
  farthest = std::min(farthest, camera.far);
  nearest = std::max({nearest, camera.near, farthest * kNearestPart});
  const double octaves = std::max(1.0, std::log2(farthest / nearest));
  slice_scale_ = kClusters.z / octaves;
  slice_offset_ = -std::log2(nearest) * slice_scale_;
  slice_starts_.assign(1, camera.near);
  for (int k = 1; k < kClusters.z; ++k) slice_starts_.push_back(std::exp2((k - slice_offset_) / slice_scale_));
  slice_starts_.push_back(std::max(camera.far, slice_starts_.back()));
}

void LightClusters::add(const View& view, const Light& light, uint32_t index) {
  if (!bounded(light)) return everywhere_.push_back(index);
  const Ball ball = widened(view.camera, light);
  const glm::dvec3 centre = view_of(view.camera, ball.centre);
  const uint32_t begin = static_cast<uint32_t>(cells_.size());
  if (view.inside(centre, ball.radius) || !find_cells(view, centre, ball.radius)) {
    cells_.resize(begin);
    return everywhere_.push_back(index);
  }
  uint32_t entries = 0;
  for (size_t i = begin; i < cells_.size(); ++i) entries += cells_[i].last - cells_[i].first + 1u;
  if (entries > 0) listed_.push_back({index, begin, static_cast<uint32_t>(cells_.size()), entries});
}

// Persson 2013, "Practical Clustered Shading": where a plane cuts off the centre, what is left of a ball lies in the
// smaller ball round the cut. So per slice, then per row, and the columns follow from the tangents of what is left.
// False if more than half of all clusters are reached.
bool LightClusters::find_cells(const View& view, const glm::dvec3& centre, double radius) {
  int entries = 0;
  for (int slice = 0; slice < kClusters.z; ++slice) {
    const double start = slice_starts_[slice], end = slice_starts_[slice + 1];
    const double depth = std::clamp(centre.z, start, end);
    const double in_slice = radius * radius - (centre.z - depth) * (centre.z - depth);
    if (in_slice <= 0) continue;
    const glm::dvec3 cut(centre.x, centre.y, depth);
    const Parts rows = parts_of(view.along(cut.y, cut.z, std::sqrt(in_slice), start), kClusters.y);
    for (int row = rows.first; row <= rows.last; ++row) {
      const double low = ndc_of(row, kClusters.y), high = ndc_of(row + 1, kClusters.y);
      const double below = std::min(0.0, view.above(cut, low)), above = std::max(0.0, view.above(cut, high));
      const double in_row = in_slice - below * below - above * above;
      if (in_row <= 0) continue;
      const glm::dvec3 p = view.moved_down(view.moved_down(cut, below, low), above, high);
      const Parts columns = parts_of(view.across(p.x, p.z, std::sqrt(in_row), start), kClusters.x);
      if (columns.last < columns.first) continue;
      cells_.push_back({static_cast<uint16_t>(slice * kClusters.y + row), static_cast<uint8_t>(columns.first),
                        static_cast<uint8_t>(columns.last)});
      entries += columns.last - columns.first + 1;
      if (entries > kClusterCount / 2) return false;
    }
  }
  return true;
}

// While there are too many entries, the widest light goes to the list that every pixel reads.
void LightClusters::keep_within(uint32_t most_entries) {
  uint64_t total = 0;
  for (const Listed& l : listed_) total += l.entries;
  if (total <= most_entries) return;
  std::sort(listed_.begin(), listed_.end(), [](const Listed& a, const Listed& b) {
    return a.entries != b.entries ? a.entries < b.entries : a.light < b.light;
  });
  for (; total > most_entries; listed_.pop_back()) {
    total -= listed_.back().entries;
    everywhere_.push_back(listed_.back().light);
  }
  std::sort(everywhere_.begin(), everywhere_.end());
  std::sort(listed_.begin(), listed_.end(), [](const Listed& a, const Listed& b) { return a.light < b.light; });
}

void LightClusters::fill(uint32_t no_light) {
  constexpr uint32_t kTexel = 4;  // words
  const auto each_cell = [&](auto use) {
    for (const Listed& l : listed_)
      for (uint32_t i = l.begin; i < l.end; ++i)
        for (int column = cells_[i].first; column <= cells_[i].last; ++column)
          use(kTexel * static_cast<uint32_t>(cells_[i].row * kClusters.x + column), l.light);
  };
  words_.assign(kTexel * kClusterCount, 0);
  each_cell([&](uint32_t head, uint32_t) { ++words_[head + 1]; });
  uint32_t texel = kClusterCount;
  const auto take = [&](size_t words) {
    return std::exchange(texel, texel + (static_cast<uint32_t>(words) + kTexel - 1) / kTexel);
  };
  for (uint32_t head = 0; head < kTexel * kClusterCount; head += kTexel)
    words_[head] = take(words_[head + 1]), words_[head + 2] = kTexel * words_[head];  // 2: where the next entry goes
  everywhere_texel_ = take(everywhere_.size());
  words_.resize(kTexel * texel, no_light);
  each_cell([&](uint32_t head, uint32_t light) { words_[words_[head + 2]++] = light; });
  std::copy(everywhere_.begin(), everywhere_.end(), words_.begin() + kTexel * everywhere_texel_);
}

std::span<const uint32_t> LightClusters::list(int cluster) const {
  return words().subspan(4 * words_[4 * cluster], words_[4 * cluster + 1]);
}

int LightClusters::cluster_at(glm::dvec2 ndc, double depth) const {
  const auto held = [](double x, int count) { return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1); };
  const int column = held((ndc.x + 1) / 2 * kClusters.x, kClusters.x);
  const int row = held((ndc.y + 1) / 2 * kClusters.y, kClusters.y);
  const int slice = held(std::log2(depth) * slice_scale_ + slice_offset_, kClusters.z);
  return (slice * kClusters.y + row) * kClusters.x + column;
}

}  // namespace gbl
