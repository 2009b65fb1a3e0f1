// Lists of lights per cluster: a small pass finds where surfaces are, the CPU lists the lights that reach them, and one
// full-screen pass reads the lists. The CPU waits for the first pass, which is left out where it does not pay.
#include <algorithm>
#include <bit>

#include "renderer/base/stopwatch.h"
#include "renderer/gl/device.h"
#include "renderer/gl/readback.h"
#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

constexpr size_t kWords = 4;  // of a texel

size_t most_words() { return kWords * gl::device().max_table_texels; }
size_t most_heads() { return most_words() / kWords / 2; }  // the other half is for the lists

// As many as a buffer of this driver holds beside the heads; lights beyond them are read by every pixel.
uint32_t most_entries(const ClusterGrid& grid) {
  const size_t heads = static_cast<size_t>(grid.tile_count() * (1 + grid.slices)), filled_up = (kWords - 1) * heads;
  const size_t words = most_words(), taken = kWords * heads + filled_up + grid.light_count + 2 * kWords;
  return static_cast<uint32_t>(std::min<size_t>(kMostClusterEntries, words - std::min(words, taken)));
}

PositionStep position_step(const Settings::Position& p) {
  constexpr double kHalf = 1.8 / 1024, kFloat = 1.8 / (1 << 23);  // cut short, of three coordinates together
  switch (p.source) {
    case PositionSource::depth:
      return {.of_coordinate = p.reconstruct == PositionReconstruct::view_ray ? 0 : 8 * kFloat};
    case PositionSource::world16f: return {.of_coordinate = kHalf};
    case PositionSource::world32f: return {.of_coordinate = kFloat};
    case PositionSource::view16f: return {.of_distance = kHalf};
    case PositionSource::view_scaled: return {.world = 0.11};  // a float of 0.5 has steps of 6e-8, and 1e6 units are 1
    case PositionSource::linear32f:
    case PositionSource::view32f: break;  // floats along the ray, or from the camera
  }
  return {};
}

void draw_depths(Frame& frame, const ClusterGrid& grid, const Canvas& into) {
  begin_drawing(into.framebuffer, into.texture.size, {});
  bind_gbuffer(frame);
  gl::Defines defines = frame.defines();
  defines.push_back({"BLOCK", kBlock});
  const gl::Program& program = frame.programs.get("fullscreen.vert", "block_depths.frag", defines);
  glUseProgram(program.id());
  glUniform1f(program.uniform("end_of_reach"), grid.end_of_reach());
  frame.shapes.draw_fullscreen();
}

// As if a surface could be anywhere.
std::vector<DepthSpan> all_depths(const ClusterGrid& grid) {
  std::vector<DepthSpan> spans(kSpans * static_cast<size_t>(grid.blocks.x * grid.blocks.y));
  double farthest = 0;  // beyond the last light nothing needs a list
  for (const LightReach& r : grid.reaches) farthest = std::max(farthest, r.centre.z + r.radius);
  const float end = std::min(grid.end_of_reach(), static_cast<float>(farthest * (1 + 1e-6)));
  for (size_t i = 0; i < spans.size(); i += kSpans) spans[i] = {grid.slice_edges.front(), end};
  return spans;
}

// Of each block.
std::vector<DepthSpan> seen_depths(Frame& frame, const ClusterGrid& grid) {
  std::optional<Canvas>& depths = frame.targets().clusters.depths;
  if (!depths || depths->texture.size != grid.blocks)
    depths = make_canvas({.size = grid.blocks, .format = Format::rgba32f, .label = "block depths"});
  draw_depths(frame, grid, *depths);
  const std::vector<float> read = gl::read_rgba32f(depths->texture);
  std::vector<DepthSpan> spans;
  for (size_t i = 0; i < read.size(); i += 2) spans.push_back({read[i], read[i + 1]});
  return spans;
}

}  // namespace

int prepare_clusters(Frame& frame) {
  ClusterTargets& t = frame.targets().clusters;
  const Stopwatch cutting;
  ClusterGrid grid = cut_for(frame.settings.camera, frame.settings.size, frame.lights(),
                             position_step(frame.settings.position), most_heads());
  grid.last = frame.resolved.special_lights;
  const double cut_ms = cutting.ms();
  const std::vector<DepthSpan> seen = grid.looks ? seen_depths(frame, grid) : all_depths(grid);
  const Stopwatch listing;
  const int draws = grid.looks ? 1 : 0;
  if (!t.clusters.build(grid, seen, most_entries(grid))) return draws;
  const std::span<const uint32_t> words = t.clusters.words();
  gl::write_texels(t.lists, Format::rgba32ui, words.data(), words.size() / 4, "light lists");
  t.ms = cut_ms + listing.ms();
  return draws;
}

int draw_clustered_lights(const LightingPass& pass) {
  const Frame& frame = pass.frame;
  const LightClusters& clusters = frame.targets().clusters.clusters;
  gl::Defines defines = pass.defines();
  defines.push_back({"ALL_LISTED_PLAIN", clusters.last_ones_everywhere() == frame.resolved.special_lights.size()});
  const gl::Program& program = frame.programs.get("fullscreen.vert", "light_clustered.frag", defines);
  glUseProgram(program.id());
  const ClusterGrid& grid = clusters.grid();
  glUniform3i(program.uniform("cuts"), std::countr_zero(static_cast<unsigned>(grid.tile_px)), grid.tiles.x,
              grid.slices);
  glUniform2f(program.uniform("slices"), static_cast<float>(grid.slice_scale), static_cast<float>(grid.slice_offset));
  const size_t all = clusters.everywhere().size(), last = clusters.last_ones_everywhere();
  glUniform4i(program.uniform("everywhere"), static_cast<int>(clusters.everywhere_texel()),
              static_cast<int>(clusters.everywhere_count() - last), static_cast<int>(all - last),
              static_cast<int>(all));
  gl::bind_texels("light_lists", frame.targets().clusters.lists);
  frame.shapes.draw_fullscreen();
  return 1;
}

}  // namespace gbl
