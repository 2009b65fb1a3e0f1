#include "renderer/frame/estimate.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "renderer/frame/method_choice.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/light/light_bounds.h"
#include "renderer/light/light_clusters.h"
#include "renderer/light/light_volume.h"

namespace gbl {
namespace {

// Of more lights than this only some are looked at: 16 384 took 20 to 40 ms, half a frame.
constexpr size_t kMostLookedAt = 512;

constexpr double kTile = 16, kBatch = kTile * kTile;  // pixels a side; lights

// A tile's surfaces span a good quarter of all depths, as measured in four scenes: most tiles hold an edge.
constexpr double kTileDepths = 0.3;

// Shares of the picture, 0 … 1.
struct Shares {
  double outline = 0;  // under the sphere's outline
  double bounds = 0;   // within its bounds on screen
};

// A circle fills pi/4 of its bounds, unless these are cut off by the picture's border.
Shares shares_of(const Settings& s, const Light& light, double scale) {
  if (!bounded(light)) return {1, 1};
  const Ball ball = reach_of(light);
  const ScreenBounds all = screen_bounds(s.camera, double(s.size.x) / s.size.y, Ball{ball.centre, ball.radius * scale});
  const double visible = clipped(all).area() / 4;
  return {std::min(visible, 3.14159265 / 4 * all.area() / 4), visible};
}

struct Depths {
  double nearest, farthest;
  double share_between(double from, double to) const {
    const double a = std::max(from, nearest), b = std::min(to, farthest);
    return a < b ? std::log(b / a) / std::log(farthest / nearest) : 0;
  }
};

// The depths at which there is any light, as the slices of the clusters.
Depths depths_of(const Camera& c, const std::vector<Light>& lights, size_t step) {
  Depths d{c.far, c.near};
  for (size_t i = 0; i < lights.size(); i += step) {
    const Light& l = lights[i];
    const double depth = view_of(c, l.position).z;
    d.nearest = std::min(d.nearest, bounded(l) ? depth - l.range : 0);
    d.farthest = std::max(d.farthest, bounded(l) ? depth + l.range : c.far);
  }
  d.farthest = std::min(d.farthest, c.far);
  d.nearest = std::max({d.nearest, c.near, d.farthest / 100});
  return d;
}

// A share of the picture, grown by a part of a cell at its rim: (side + cell)^2.
double grown(double share, double cell) {
  const double side = std::sqrt(share) + cell;
  return share > 0 ? std::min(1.0, side * side) : 0;
}

// Nearly all clusters, and every pixel reads the light.
double share_in_clusters(double outline, double thick, double tile) {
  const double share = grown(outline, tile) * std::min(1.0, thick + 1.0 / kMostSlices);
  return share > kNearlyAll ? 1 : share;
}

}  // namespace

LightsInView lights_in_view(const Settings& s, const std::vector<Light>& lights) {
  LightsInView v;
  v.pixels = double(s.size.x) * s.size.y;
  v.lights = double(lights.size());
  const double scale = volume_scale(s.lights.volume.fit, s.lights.volume.level, VolumeShape::sphere),
               faces = s.lights.cull == LightCull::none ? 2 : 1;
  const double tile = kTile / std::sqrt(v.pixels);
  const size_t step = std::max<size_t>(1, lights.size() / kMostLookedAt);
  const Depths depths = depths_of(s.camera, lights, step);
  for (size_t i = 0; i < lights.size(); i += step) {
    const Light& l = lights[i];
    const Shares own = shares_of(s, l, 1), volume = scale == 1 ? own : shares_of(s, l, scale);
    const double depth = view_of(s.camera, l.position).z;
    const double thick = bounded(l) ? depths.share_between(depth - l.range, depth + l.range) : 1;
    v.reached += v.pixels * own.outline * thick;
    v.under_volumes += v.pixels * volume.outline * faces;
    v.under_quads += v.pixels * own.bounds;
    v.in_tiles += v.pixels * grown(own.outline, tile) * std::min(1.0, thick + kTileDepths);
    v.in_clusters += v.pixels * share_in_clusters(own.outline, thick, tile);
  }
  const double looked_at = double((lights.size() + step - 1) / step), stands_for = step > 1 ? v.lights / looked_at : 1;
  for (double* sum : {&v.reached, &v.under_volumes, &v.under_quads, &v.in_tiles, &v.in_clusters}) *sum *= stands_for;
  v.volume_triangles = 20 * std::pow(4, static_cast<int>(s.lights.volume.level));
  return v;
}

namespace {

// Pairs tested and shaded, and the rest of the work.
LightWork work(double tested, double shaded, std::initializer_list<std::pair<Work, double>> parts) {
  LightWork w{tested, shaded, {}, 0};
  for (const auto& [kind, count] : parts) w.counts[kind] += count;
  w.units = units_of(w.counts, work_weights());
  return w;
}

LightWork fullscreen(const LightsInView& v) {
  const double pairs = v.pixels * v.lights;
  return work(pairs, pairs, {{Work::pixel, v.pixels}, {Work::turn, pairs}});
}

LightWork fullscreen_radius(const LightsInView& v) {
  const double pairs = v.pixels * v.lights;
  return work(pairs, v.reached, {{Work::pixel, v.pixels}, {Work::turn, pairs}, {Work::second_test, v.reached}});
}

double triangles(const LightsInView& v) { return v.lights * v.volume_triangles; }

// Every fragment is a pair that is read and shaded.
LightWork volumes(const LightsInView& v) {
  const double fragments = v.under_volumes;
  return work(fragments, fragments,
              {{Work::cleared, v.pixels},
               {Work::mesh_fragment, fragments},
               {Work::draw, v.lights},
               {Work::triangle, triangles(v)}});
}
LightWork volumes_instanced(const LightsInView& v) {
  const double fragments = v.under_volumes;
  return work(
      fragments, fragments,
      {{Work::cleared, v.pixels}, {Work::mesh_fragment, fragments}, {Work::draw, 2}, {Work::triangle, triangles(v)}});
}
// Both faces of each volume are marked, and what is inside is shaded.
LightWork volumes_stencil(const LightsInView& v) {
  return work(v.reached, v.reached,
              {{Work::cleared, v.pixels},
               {Work::fragment, v.reached},
               {Work::mark, 2 * v.under_volumes},
               {Work::draw, 2 * v.lights},
               {Work::triangle, 5 * triangles(v)}});
}
LightWork quads(const LightsInView& v) {
  return work(v.under_quads, v.under_quads,
              {{Work::cleared, v.pixels}, {Work::fragment, v.under_quads}, {Work::quad, v.lights}});
}
LightWork discs(const LightsInView& v) {
  return work(v.under_volumes, v.under_volumes,
              {{Work::cleared, v.pixels}, {Work::mesh_fragment, v.under_volumes}, {Work::disc, v.lights}});
}

LightWork tiled(const LightsInView& v) {
  const double batches = std::ceil(v.lights / kBatch) * std::max(1.0, v.pixels / (kTile * kTile));
  return work(v.in_tiles, v.reached,
              {{Work::pixel, v.pixels},
               {Work::tile_batch, batches},
               {Work::marked, v.in_tiles},
               {Work::second_test, v.reached}});
}

LightWork clustered(const LightsInView& v) {
  const double entries = std::min<double>(kMostClusterEntries, 2.2 / (kTile * kTile) * v.in_clusters);
  return work(v.in_clusters, v.reached,
              {{Work::pixel, v.pixels},
               {Work::cluster_pixel, v.pixels},
               {Work::listed_light, v.lights},
               {Work::list_entry, entries},
               {Work::listed, v.in_clusters}});
}

struct WorkOfMethod {
  LightMethod method;
  LightWork (*work)(const LightsInView&);
};
constexpr WorkOfMethod kWorkOf[] = {
    {LightMethod::forward, fullscreen},  // hidden surfaces apart: nobody knows them yet
    {LightMethod::forward_prepass, fullscreen},
    {LightMethod::forward_multipass, fullscreen},
    {LightMethod::prepass, fullscreen_radius},
    {LightMethod::fullscreen, fullscreen},
    {LightMethod::fullscreen_radius, fullscreen_radius},
    {LightMethod::volumes, volumes},
    {LightMethod::volumes_instanced, volumes_instanced},
    {LightMethod::volumes_stencil, volumes_stencil},
    {LightMethod::quads, quads},
    {LightMethod::disc, discs},
    {LightMethod::tiled, tiled},
    {LightMethod::clustered, clustered},
};
constexpr bool in_order() {
  for (size_t i = 0; i < std::size(kWorkOf); ++i)
    if (kWorkOf[i].method != static_cast<LightMethod>(i)) return false;
  return true;
}
static_assert(in_order());

}  // namespace

LightWork work_of(LightMethod method, const LightsInView& v) {
  return v.lights > 0 ? kWorkOf[static_cast<size_t>(method)].work(v) : LightWork{};
}

double estimate_work(const Settings& s, const std::vector<Light>& lights) {
  return work_of(choose_method(s, lights, {}).method, lights_in_view(s, lights)).units;
}

// First guesses where the device was not measured, kept only until the first frame: 2 ns is llvmpipe on two cores,
// 0.02 ns a small GPU.
FrameCost::FrameCost(bool software) : first_guess_ns_(software ? 2 : 0.02), ns_per_pixel_(software ? 60 : 1) {
  if (work_weights().ns_per_unit > 0) first_guess_ns_ = work_weights().ns_per_unit;
}

// Of a method that was not drawn yet: as of the quickest, for what a method does beyond its units only adds to them.
double FrameCost::ns_per_unit(LightMethod m) const {
  if (const auto known = learnt_ns_.find(m); known != learnt_ns_.end()) return known->second;
  const auto quickest = std::min_element(learnt_ns_.begin(), learnt_ns_.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
  return quickest == learnt_ns_.end() ? first_guess_ns_ : quickest->second;
}

// In little work, much of the time is not the work's: it says what a unit costs at most. One frame that took far too long,
// as when the machine slept, is forgotten at the next: by halves, pictures would stay small for long.
void FrameCost::learn(LightMethod m, double work, double lighting_ms) {
  constexpr double kMuch = 1e5;
  if (!(work > 0) || !(lighting_ms > 0)) return;
  const double now = ns_per_unit(m), seen = lighting_ms * 1e6 / work;
  if (seen < (work < kMuch ? now : now / 4))
    learnt_ns_[m] = seen;
  else if (work >= kMuch)
    learnt_ns_[m] = 0.5 * now + 0.5 * seen;
}

double FrameCost::ms_of(LightMethod m, double work, glm::ivec2 size) const {
  return (work * ns_per_unit(m) + double(size.x) * size.y * ns_per_pixel_) * 1e-6;
}

double FrameCost::predict_ms(const ResolvedFrame& f) const {
  return ms_of(f.settings.lights.method, f.light_work, f.settings.size);
}

glm::ivec2 FrameCost::affordable_size(const ResolvedFrame& f, glm::ivec2 size, double budget_ms) const {
  Settings smaller = f.settings;
  const auto predicted = [&](glm::ivec2 at) {
    smaller.size = at;
    return ms_of(smaller.lights.method, estimate_work(smaller, f.lights), at);
  };
  if ((size == f.settings.size ? predict_ms(f) : predicted(size)) <= budget_ms) return size;
  const auto shrunk = [&](double factor) { return glm::ivec2(glm::dvec2(size) * factor + 1e-6); };
  // Not all of the work is in proportion to the pixels, but all of it grows with them.
  double fits = std::min(1.0, 64.0 / std::min(size.x, size.y)), too_large = 1;
  while (too_large - fits > 1e-3) {
    const double middle = (fits + too_large) / 2;
    (predicted(shrunk(middle)) <= budget_ms ? fits : too_large) = middle;
  }
  return shrunk(fits);  // 64 stays 64 after its two roundings
}

}  // namespace gbl
