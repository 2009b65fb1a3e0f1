// Lists of lights per cluster, built on the CPU once per frame, then one full-screen pass that reads them.
#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

constexpr int kListTextureWidth = 2048;

// Whole rows at once, then what is left.
void upload_words(gl::Texture& texture, std::span<const uint32_t> words) {
  const int rows = static_cast<int>(words.size()) / kListTextureWidth;
  const int rest = static_cast<int>(words.size()) % kListTextureWidth;
  // A quarter more than needed, so that lists which grow a little from frame to frame get no new texture each time.
  if (!texture.name || texture.size.y <= rows || texture.size.y > 4 * (rows + 1))
    texture = gl::make_texture(
        {.size = {kListTextureWidth, 1 + rows + rows / 4}, .format = Format::r32ui, .label = "light lists"});
  const gl::GlFormat& f = gl::gl_format(Format::r32ui);
  gl::bind_texture("light_lists", texture);
  gl::state_pixel_storage();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kListTextureWidth, rows, f.format, f.type, words.data());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, rows, rest, 1, f.format, f.type, words.last(rest).data());
}

}  // namespace

void prepare_clusters(Frame& frame) {
  Uploads& up = frame.targets().uploads;
  up.clusters.build(frame.settings.camera, frame.resolved.aspect, frame.lights());
  upload_words(up.light_lists, up.clusters.words());
}

int draw_clustered_lights(const LightingPass& pass) {
  const Frame& frame = pass.frame;
  const LightClusters& clusters = frame.targets().uploads.clusters;
  gl::Defines defines = pass.defines();
  defines.push_back({"CLUSTER_COLUMNS", kClusters.x});
  defines.push_back({"CLUSTER_ROWS", kClusters.y});
  defines.push_back({"CLUSTER_SLICES", kClusters.z});
  defines.push_back({"LIST_TEXTURE_WIDTH", kListTextureWidth});
  const gl::Program& program = frame.programs.get("fullscreen.vert", "light_clustered.frag", defines);
  glUseProgram(program.id());
  glUniform2f(program.uniform("slices"), static_cast<float>(clusters.slice_scale()),
              static_cast<float>(clusters.slice_offset()));
  glUniform2i(program.uniform("everywhere"), static_cast<int>(clusters.everywhere_start()),
              static_cast<int>(clusters.everywhere().size()));
  gl::bind_texture("light_lists", frame.targets().uploads.light_lists);
  frame.shapes.draw_fullscreen();
  return 1;
}

}  // namespace gbl
