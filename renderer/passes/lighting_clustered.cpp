// Lists of lights per cluster, built on the CPU once per frame, then one full-screen pass that reads them.
#include <algorithm>

#include "renderer/gl/device.h"
#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

// As many as a buffer of this driver holds; lights beyond them are read by every pixel.
uint32_t most_entries(size_t lights) {
  constexpr size_t kWords = 4, kFilledUp = (kWords - 1) * kClusterCount;  // at most, at the lists' ends
  const size_t words = kWords * gl::device().max_buffer_texels,
               taken = kWords * kClusterCount + kFilledUp + lights + kWords;
  return static_cast<uint32_t>(std::min<size_t>(kMostClusterEntries, words - std::min(words, taken)));
}

}  // namespace

void prepare_clusters(Frame& frame) {
  Uploads& up = frame.targets().uploads;
  up.clusters.build(frame.settings.camera, frame.resolved.aspect, frame.lights(), most_entries(frame.lights().size()));
  const std::span<const uint32_t> words = up.clusters.words();
  gl::write_texels(up.light_lists, Format::rgba32ui, words.data(), words.size() / 4, "light lists");
}

int draw_clustered_lights(const LightingPass& pass) {
  const Frame& frame = pass.frame;
  const LightClusters& clusters = frame.targets().uploads.clusters;
  gl::Defines defines = pass.defines();
  defines.push_back({"CLUSTER_COLUMNS", kClusters.x});
  defines.push_back({"CLUSTER_ROWS", kClusters.y});
  defines.push_back({"CLUSTER_SLICES", kClusters.z});
  const gl::Program& program = frame.programs.get("fullscreen.vert", "light_clustered.frag", defines);
  glUseProgram(program.id());
  glUniform2f(program.uniform("slices"), static_cast<float>(clusters.slice_scale()),
              static_cast<float>(clusters.slice_offset()));
  glUniform2i(program.uniform("everywhere"), static_cast<int>(clusters.everywhere_texel()),
              static_cast<int>(clusters.everywhere().size()));
  gl::bind_texels("light_lists", frame.targets().uploads.light_lists);
  frame.shapes.draw_fullscreen();
  return 1;
}

}  // namespace gbl
