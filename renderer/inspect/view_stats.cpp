#include "renderer/inspect/view_stats.h"

#include <algorithm>
#include <cmath>

#include "renderer/inspect/view_legends.h"

namespace gbl {
namespace {

constexpr int kMostSamples = 65536;

// Have all of its channels a number?
bool finite(const glm::vec4& v, int components) {
  for (int k = 0; k < components; ++k)
    if (!std::isfinite(v[k])) return false;
  return true;
}

void fill_bins(ViewStats& s, std::span<const glm::vec4> values, int components) {
  const double span = s.binned.y - s.binned.x;
  for (const glm::vec4& v : values)
    for (int k = 0; k < components && v.w > 0.5f; ++k) {
      if (!std::isfinite(v[k])) continue;
      const double t = span > 0 ? (double(v[k]) - s.binned.x) / span : 0;
      const int bin = std::clamp(static_cast<int>(t * ViewStats::kBins), 0, ViewStats::kBins - 1);
      ++s.bins[static_cast<size_t>(k)][static_cast<size_t>(bin)];
    }
}

}  // namespace

PixelGrid sample_grid(glm::ivec2 size) {
  int step = 1;
  const auto count = [&] { return (size + step - 1) / step; };
  while (count().x * count().y > kMostSamples) ++step;
  return {{0, 0}, glm::ivec2(step), count()};
}

glm::dvec2 round_range(double least, double most) {
  const double span = most - least;
  if (!(span > 0)) {  // all alike: a bar around them
    const double half = least == 0 ? 0.5 : std::abs(least) / 2;
    return {least - half, least + half};
  }
  const double unit = std::pow(10, std::floor(std::log10(span))) / 2;
  const double from = std::floor(least / unit) * unit;
  return {from, from + round_for_bar(most - from)};
}

glm::dvec2 fitted_range(const ViewStats& s, int components, std::string_view channels) {
  if (components == 1) return round_range(s.min.x, s.max.x);
  double least = INFINITY, most = -INFINITY;
  for (const char c : channels) {
    const auto k = static_cast<glm::length_t>(std::string_view("rgb").find(c));
    least = std::min(least, s.min[k]), most = std::max(most, s.max[k]);
  }
  return round_range(least, most);
}

ViewStats view_stats(std::span<const glm::vec4> values, int components) {
  ViewStats s;
  glm::dvec3 sum(0);
  size_t finite_pixels = 0;
  for (const glm::vec4& v : values) {
    if (v.w <= 0.5f) continue;
    ++s.pixels;
    if (!finite(v, components)) {
      ++s.nonfinite;
      continue;
    }
    const glm::dvec3 x(v);
    if (finite_pixels++ == 0) s.min = s.max = x;
    if (x.x >= 0 && x.x < 7.5) ++s.whole[static_cast<size_t>(x.x + 0.5)];
    s.min = glm::min(s.min, x), s.max = glm::max(s.max, x), sum += x;
    bool below = false;
    for (int k = 0; k < components; ++k) below |= v[k] < 0;
    s.negative += below;
  }
  if (finite_pixels == 0) return s;
  s.mean = sum / static_cast<double>(finite_pixels);
  s.binned = {s.min.x, s.max.x};
  for (int k = 1; k < components; ++k) s.binned = {std::min(s.binned.x, s.min[k]), std::max(s.binned.y, s.max[k])};
  fill_bins(s, values, components);
  return s;
}

}  // namespace gbl
