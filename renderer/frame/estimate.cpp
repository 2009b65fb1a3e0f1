#include "renderer/frame/estimate.h"

#include <algorithm>
#include <cmath>

#include "renderer/frame/method_choice.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/light/light_bounds.h"
#include "renderer/light/light_clusters.h"
#include "renderer/light/light_volume.h"

namespace gbl {
namespace {

// What the parts of the methods cost, in units of one turn of the full-screen loop: a light's record read, its distance
// taken, and its shading if it is in range, four lights at once. Measured with llvmpipe on two cores in the hall, 16 to
// 16 384 lights, from local ones to all that reach all: the turn took 1.7 to 2 ns.
constexpr double kPixel = 6;         // a full-screen pass reads the G-buffer and writes its sums
constexpr double kSecondTest = 0.1;  // of a distance that shade() tests again
constexpr double kFindCluster = 6;   // a pixel's depth is looked at, and it looks up where its list is
constexpr double kListed = 1.3;      // a turn of a loop whose lights come from a cluster's list
constexpr double kMarked = 1.1;      // … and from a tile's bits
constexpr double kFragment = 7.2;    // a pair with a fragment of its own: it reads the G-buffer, shades and blends
constexpr double kMeshFragment = 9;  // … of a mesh: its small triangles leave blocks of pixels half used
constexpr double kMark = 1;          // a fragment that is only tested against depth
constexpr double kDraw = 2000;
constexpr double kTriangle = 40;  // of a mesh
constexpr double kQuad = 400;
constexpr double kDisc = 3600;
constexpr double kTileBatch = 7600;   // one tile tests 256 lights, with its barriers
constexpr double kListedLight = 80;  // a light is put into lists, on the CPU
constexpr double kListEntry = 25;

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

// Half of all clusters, and every pixel reads the light.
double share_in_clusters(double outline, double thick, double tile) {
  const double share = grown(outline, tile) * std::min(1.0, thick + 1.0 / kMostSlices);
  return share > 0.875 ? 1 : share;
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

LightWork fullscreen(const LightsInView& v) {
  const double pairs = v.pixels * v.lights;
  return {pairs, pairs, kPixel * v.pixels + pairs};
}

LightWork fullscreen_radius(const LightsInView& v) {
  const double pairs = v.pixels * v.lights;
  return {pairs, v.reached, kPixel * v.pixels + pairs + kSecondTest * v.reached};
}

// Every fragment is a pair that is read and shaded.
LightWork blended(double fragments, double each, double setup) {
  return {fragments, fragments, each * fragments + setup};
}

LightWork volumes(const LightsInView& v) {
  return blended(v.under_volumes, kMeshFragment, v.lights * (kDraw + kTriangle * v.volume_triangles));
}
LightWork volumes_instanced(const LightsInView& v) {
  return blended(v.under_volumes, kMeshFragment, 2 * kDraw + v.lights * kTriangle * v.volume_triangles);
}
// Both faces of each volume are marked, and what is inside is shaded.
LightWork volumes_stencil(const LightsInView& v) {
  const double marks = 2 * kMark * v.under_volumes, setup = v.lights * (2 * kDraw + 5 * kTriangle * v.volume_triangles);
  return {v.reached, v.reached, kFragment * v.reached + marks + setup};
}
LightWork quads(const LightsInView& v) { return blended(v.under_quads, kFragment, v.lights * kQuad); }
LightWork discs(const LightsInView& v) { return blended(v.under_volumes, kMeshFragment, v.lights * kDisc); }

LightWork tiled(const LightsInView& v) {
  const double batches = std::ceil(v.lights / kBatch) * std::max(1.0, v.pixels / (kTile * kTile));
  return {v.in_tiles, v.reached,
          kPixel * v.pixels + kTileBatch * batches + kMarked * v.in_tiles + kSecondTest * v.reached};
}

LightWork clustered(const LightsInView& v) {
  const double entries = std::min<double>(kMostClusterEntries, 2.2 / (kTile * kTile) * v.in_clusters);
  return {
      v.in_clusters, v.reached,
      (kPixel + kFindCluster) * v.pixels + kListedLight * v.lights + kListEntry * entries + kListed * v.in_clusters};
}

struct WorkRow {
  LightMethod method;
  LightWork (*work)(const LightsInView&);
};
constexpr WorkRow kWork[] = {
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
  for (size_t i = 0; i < std::size(kWork); ++i)
    if (kWork[i].method != static_cast<LightMethod>(i)) return false;
  return true;
}
static_assert(in_order());

}  // namespace

LightWork work_of(LightMethod method, const LightsInView& v) {
  return v.lights > 0 ? kWork[static_cast<size_t>(method)].work(v) : LightWork{};
}

double estimate_work(const Settings& s, const std::vector<Light>& lights) {
  return work_of(choose_method(s, lights, {}).method, lights_in_view(s, lights)).units;
}

// First guesses, kept only until the first frame: 2 ns is llvmpipe on two cores, 0.02 ns a small GPU.
FrameCost::FrameCost(bool software) : ns_per_unit_(software ? 2 : 0.02), ns_per_pixel_(software ? 60 : 1) {}

void FrameCost::learn(double work, double lighting_ms) {
  if (work < 1e5 || !(lighting_ms > 0)) return;  // too little to learn from
  ns_per_unit_ = 0.5 * ns_per_unit_ + 0.5 * lighting_ms * 1e6 / work;
}

double FrameCost::ms_of(double work, glm::ivec2 size) const {
  return (work * ns_per_unit_ + double(size.x) * size.y * ns_per_pixel_) * 1e-6;
}

double FrameCost::predict_ms(const ResolvedFrame& f) const { return ms_of(f.light_work, f.settings.size); }

glm::ivec2 FrameCost::affordable_size(const ResolvedFrame& f, glm::ivec2 size, double budget_ms) const {
  Settings smaller = f.settings;
  const auto predicted = [&](glm::ivec2 at) {
    smaller.size = at;
    return ms_of(estimate_work(smaller, f.lights), at);
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
