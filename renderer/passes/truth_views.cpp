// What the reference needs to see, what the measures need decoded, and the two views that show the truth.
#include <glm/gtc/type_ptr.hpp>

#include "renderer/passes/judging.h"
#include "renderer/passes/objects.h"
#include "renderer/picture/colour_map.h"
#include "renderer/truth/error_stats.h"

namespace gbl {
namespace {

constexpr float kNothing[4] = {};

gl::Defines error_defines(const Frame& frame, ErrorOf chosen) {
  gl::Defines defines = frame.defines();
  defines.push_back({"SPLIT", frame.resolved.split});
  append_axis(defines, "ERROR_OF", "ERROR_", chosen);
  return defines;
}

void draw_reference(const Frame& frame, const TruthTextures& truth) {
  gl::bind_texture("truth_lit", truth.lit);
  glUseProgram(frame.programs.get("fullscreen.vert", shader_of(View::reference), frame.defines()).id());
  frame.shapes.draw_fullscreen();
}

}  // namespace

void colour_errors(ProgramCache& programs, Shapes& shapes, const gl::Texture& errors, ErrorScale scale, double range) {
  const bool with_sign = scale == ErrorScale::with_sign;
  const std::span<const glm::vec3> stops = stops_of(with_sign ? ColourMap::diverging : ColourMap::magma);
  const int count = static_cast<int>(stops.size());
  gl::bind_texture("errors", errors);
  const gl::Program& program =
      programs.get("fullscreen.vert", shader_of(View::error), {{"COLOUR_STOPS", count}, {"SIGNED", with_sign}});
  glUseProgram(program.id());
  glUniform3fv(program.uniform("stops"), count, glm::value_ptr(stops[0]));
  glUniform1f(program.uniform("range"), static_cast<float>(range));
  glUniform3fv(program.uniform("tie_colour"), 1, glm::value_ptr(kTieColour));
  glUniform3fv(program.uniform("empty_colour"), 1, glm::value_ptr(row(View::error).empty_colour));
  shapes.draw_fullscreen();
}

void draw_truth_view(const Frame& frame, View view, const ViewOptions& options, Canvas& into) {
  begin_drawing(into.framebuffer, frame.settings.size, {});
  if (view == View::reference)
    draw_reference(frame, *options.truth);
  else
    colour_errors(frame.programs, frame.shapes, frame.targets().canvases.errors().texture, frame.view.error.scale,
                  options.error_range);
}

void draw_truth_numbers(const Frame& frame, View view, const ViewOptions& options, const PixelGrid& pixels,
                        Canvas& into) {
  begin_drawing(into.framebuffer, pixels.count, {});
  gl::bind_texture("numbers", view == View::reference ? options.truth->lit : frame.targets().canvases.errors().texture);
  const gl::Program& program = frame.programs.get("fullscreen.vert", "numbers.frag", {});
  glUseProgram(program.id());
  set_pixel_grid(program, frame.settings.size, pixels);
  frame.shapes.draw_fullscreen();
}

void Renderer::draw_seen(const Settings& s, const GpuScene& scene, Targets& targets, const gl::Framebuffer& into,
                         const gl::Texture* uvs_moved) {
  Frame frame = frame_of(s, scene, targets);
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  begin_drawing(into, s.size, depth_tested(frame, gl::DepthTest::less, {.depth_write = true}));
  for (int k = 0; k < kSeenTexels; ++k) glClearBufferfv(GL_COLOR, k, kNothing);
  const float farthest = frame.resolved.depth_runs == DepthRuns::reversed ? 0.0f : 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  gl::Defines defines = frame.surface_defines();
  defines.push_back({"TRIANGLE_IDS", 1});
  defines.push_back({"UVS_MOVED", uvs_moved != nullptr});
  if (uvs_moved) gl::bind_texture("uvs_moved", *uvs_moved);
  draw_objects(frame, draws, "seen.frag", defines, {}, Corners::numbered);
}

const Canvases::Surfaces& Renderer::draw_surfaces(const Settings& s, const GpuScene& scene, Targets& targets) {
  Canvases::Surfaces& surfaces = targets.canvases.surfaces(targets.frame);
  if (!targets.canvases.surfaces_valid) draw_seen(s, scene, targets, surfaces.framebuffer);
  targets.canvases.surfaces_valid = true;
  gl::bind_texture("surfaces", surfaces.seen);
  gl::bind_texture("surfaces_depth", surfaces.depth);
  return surfaces;
}

SeenSurface Renderer::surface_at(const Settings& s, const GpuScene& scene, Targets& targets, glm::ivec2 pixel) {
  const Canvases::Surfaces& surfaces = draw_surfaces(s, scene, targets);
  const gl::Texture* const textures[] = {&surfaces.seen, &surfaces.depth, targets.frame.texture(Stores::depth)};
  gl::AsyncTexels read;
  read.start(textures, {pixel.x, s.size.y - 1 - pixel.y});
  const std::vector<std::array<uint32_t, 4>> bits = read.take(true).value();
  if (bits[1] != bits[2]) return {-1, -1};
  return {static_cast<int>(glm::uintBitsToFloat(bits[0][0])), static_cast<int>(glm::uintBitsToFloat(bits[0][1]))};
}

void Renderer::draw_decoded(const Settings& s, const GpuScene& scene, Targets& targets, const gl::Framebuffer& into) {
  draw_surfaces(s, scene, targets);
  const Frame frame = frame_of(s, scene, targets);
  begin_drawing(into, s.size, {});
  bind_gbuffer(frame);
  glUseProgram(programs_.get("fullscreen.vert", "decoded.frag", frame.defines()).id());
  shapes_.draw_fullscreen();
}

void Renderer::draw_errors(const Settings& s, const GpuScene& scene, Targets& targets, const TruthTextures& truth) {
  draw_surfaces(s, scene, targets);
  const Frame frame = frame_of(s, scene, targets);
  Canvas& canvas = targets.canvases.errors();
  begin_drawing(canvas.framebuffer, s.size, {});
  bind_gbuffer(frame);
  bind_light_sums(frame);
  gl::bind_texture("lit", frame.texture(Stores::lit));
  gl::bind_texture("truth_lit", truth.lit);
  gl::bind_texture("truth_value", truth.of(s.view.error.of));
  glUseProgram(programs_.get("fullscreen.vert", "error.frag", error_defines(frame, s.view.error.of)).id());
  shapes_.draw_fullscreen();
  targets.reads.error.start(canvas.texture);
}

}  // namespace gbl
