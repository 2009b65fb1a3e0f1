// The pictures for the eye, and the wires over them. Look; do not touch: what they read is never changed.
#include "renderer/inspect/views.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/options/view_look.h"
#include "renderer/passes/frame_block.h"
#include "renderer/passes/lighting.h"
#include "renderer/passes/volumes.h"

namespace gbl {
namespace {

// The wires of one shape: of all lights, or of the picked one.
void draw_wires(const Frame& frame, VolumeShape shape) {
  const Settings& s = frame.settings;
  const std::vector<Light>& lights = frame.lights();
  const size_t picked = std::min(static_cast<size_t>(frame.view.pick), lights.size() - 1);
  gl::Defines defines = frame.defines();
  defines.push_back({"SHAPE", static_cast<int>(shape)});
  const gl::Program& program = frame.programs.get("volume_wire.vert", "volume_wire.frag", defines);
  const GpuVolume& mesh = frame.shapes.volume(shape, s.lights.volume.level);
  glUseProgram(program.id());
  set_mesh_uniforms(program, s, shape, 0);
  glBindVertexArray(mesh.wire.id());
  for (size_t i = 0; i < lights.size(); ++i) {
    if (volume_shape(lights[i]) != shape || (frame.view.volumes == VolumeOverlay::picked && i != picked)) continue;
    glUniform1i(program.uniform("light_index"), static_cast<GLint>(i));
    glDrawElements(GL_LINES, mesh.edge_indices, GL_UNSIGNED_INT, nullptr);
  }
}

}  // namespace

void draw_volume_wires(const Frame& frame, Canvas& into) {
  if (frame.view.volumes == VolumeOverlay::off) return;
  begin_drawing(into.framebuffer, frame.settings.size, {.blend = gl::Blend::alpha});
  bind_gbuffer(frame);
  bind_lights(frame);
  for (const VolumeShape shape : kMeshShapes)
    if (any_light(frame, shape)) draw_wires(frame, shape);
}

namespace {

// What the programs of a view read, beside the defines that they are compiled with.
void bind_view(Frame& frame, View view) {
  Canvases& canvases = frame.targets().canvases;
  if (row(view).numbered && !frame.targets().frame.texture(Stores::id)) draw_ids(frame);
  if (row(view).redrawn) draw_redrawn(frame);
  bind_gbuffer(frame);
  bind_light_sums(frame);
  bind_lights(frame);
  gl::bind_texture("lit",
                   row(view).with_transparent ? canvases.shown(frame.targets().frame) : frame.texture(Stores::lit));
  if (counted(view)) gl::bind_texture("counts", canvases.counts().texture);
  if (row(view).against_lit) gl::bind_texture("counts_lit", canvases.counts_lit().texture);
  if (row(view).redrawn) {
    gl::bind_texture("redrawn_counts", canvases.redrawn_counts().texture);
    gl::bind_texture("redrawn_triangles", canvases.redrawn_triangles().texture);
  }
  if (canvases.ids_valid) gl::bind_texture("ids", canvases.ids().texture);
}

gl::Defines view_defines(const Frame& frame, View view, int as) {
  gl::Defines defines = frame.defines();
  defines.push_back({"SPLIT", frame.resolved.split});
  defines.push_back({"VIEW_FILE", shader_of(view)});
  defines.push_back({"VIEW_AS", as});
  defines.push_back({"BACKGROUND_TOO", row(view).values.background});
  defines.push_back({"VIEW_MARKS", row(view).marks});
  return defines;
}

// Of tiles or clusters; the others have one cell for the whole picture.
glm::vec2 cells_per_pixel(const Frame& frame) {
  switch (frame.settings.lights.method) {
    case LightMethod::tiled: return glm::vec2(1.0f / kTile);
    case LightMethod::clustered:
      if (frame.lights().empty()) return glm::vec2(0);  // nothing is listed
      return glm::vec2(1.0f / static_cast<float>(frame.targets().clusters.clusters.grid().tile_px));
    default: return glm::vec2(0);
  }
}

void set_colours(const Frame& frame, const gl::Program& program, View view, const glm::dvec2& range,
                 const ViewStats* stats) {
  std::array<glm::vec3, kMostClasses> colours{};
  for (size_t i = 0; i < row(view).classes.size(); ++i) colours[i] = row(view).classes[i].colour;
  const glm::vec2 cells = cells_per_pixel(frame);
  glUniform2f(program.find_uniform("cells_per_pixel"), cells.x, cells.y);
  glUniform3fv(program.find_uniform("class_colours"), kMostClasses, glm::value_ptr(colours[0]));
  const CountSteps from = count_steps(stats);
  glUniform3fv(program.find_uniform("empty_colour"), 1, glm::value_ptr(row(view).empty_colour));
  glUniform2f(program.find_uniform("black_and_white"), static_cast<float>(range.x), static_cast<float>(range.y));
  glUniform1iv(program.find_uniform("count_from"), kLightCountColours, from.data());
  glUniform3fv(program.find_uniform("count_palette"), kLightCountColours, glm::value_ptr(kLightCountPalette[0]));
}

void set_picked_light(const Frame& frame, const gl::Program& program) {
  glUniform1i(program.find_uniform("picked_light"), std::min(frame.view.pick, frame.light_count() - 1));
}

// The program of a look; its uniforms are set.
const gl::Program& use_look(const Frame& frame, View view, const ViewLook& look) {
  const bool single = single_number(view, look);
  const auto stops = stops_of(look.map == ColourMap::own ? ColourMap::grey : look.map);
  gl::Defines defines = view_defines(frame, view, VIEW_AS_LOOK);
  defines.push_back({"LOOK_STOPS", single ? static_cast<int>(stops.size()) : 0});
  defines.push_back({"LOOK_CODED", look.coded.value_or(row(view).values.coded)});
  const gl::Program& program = frame.programs.get("fullscreen.vert", "views.frag", defines);
  glUseProgram(program.id());
  set_picked_light(frame, program);
  const auto shown = [&](char channel) { return look.channels.find(channel) == std::string::npos ? 0.0f : 1.0f; };
  glUniform3f(program.find_uniform("look_channels"), shown('r'), shown('g'), shown('b'));
  if (!single) return program;
  glUniform3fv(program.uniform("look_stops"), static_cast<GLsizei>(stops.size()), glm::value_ptr(stops[0]));
  glUniform1i(program.find_uniform("look_channel"), static_cast<GLint>(std::string_view("rgb").find(look.channels[0])));
  return program;
}

const gl::Program& use_view(const Frame& frame, View view, int as) {
  const gl::Program& program = frame.programs.get("fullscreen.vert", "views.frag", view_defines(frame, view, as));
  glUseProgram(program.id());
  set_picked_light(frame, program);
  return program;
}

}  // namespace

// Pictures begin at the top, texels at the bottom: the rows of the grid are turned round.
void set_pixel_grid(const gl::Program& program, glm::ivec2 size, const PixelGrid& pixels) {
  const int last = pixels.first.y + (pixels.count.y - 1) * pixels.step.y;
  glUniform4i(program.find_uniform("pixel_grid"), pixels.first.x, size.y - 1 - last, pixels.step.x, pixels.step.y);
}

void Renderer::draw_view(View view, const Settings& s, const GpuScene& scene, Targets& targets,
                         const ViewOptions& options) {
  count_for(view, s, scene, targets);
  Frame frame = frame_of(s, scene, targets);
  if (needs_truth(view)) return draw_truth_view(frame, view, options, targets.canvases.view(view));
  Canvas& canvas = targets.canvases.view(view);
  {
    const gl::PassScope scope(targets.timers, "views");
    bind_view(frame, view);
    begin_drawing(canvas.framebuffer, s.size, {});
    const ViewLook look = look_of(s.view.looks, row(view).id);
    const gl::Program& program = options.raw || look.raw ? use_view(frame, view, VIEW_AS_STORED)
                                 : look.plain()          ? use_view(frame, view, VIEW_AS_SHOWN)
                                                         : use_look(frame, view, look);
    set_colours(frame, program, view, shown_range(view, s, scene.scene().bounds, options.stats), options.stats);
    shapes_.draw_fullscreen();
  }
  const bool of_the_picture = view != View::shadow_maps;  // what is laid over it is
  if (options.overlays && of_the_picture) draw_overlays(view, s, scene, targets, options, canvas);
}

// The topmost last; then the wires and the outline, which cover little. What an overlay counts is a pass of its own: no
// timer runs within another.
void Renderer::draw_overlays(View under, const Settings& s, const GpuScene& scene, Targets& targets,
                             const ViewOptions& options, Canvas& into) {
  for (const Overlay& o : s.view.overlays) {
    const View view = view_by_id(o.view).view;
    if (view == under || needs_truth(view) || !why_missing(view, targets.drawn->settings).empty()) continue;
    count_for(view, s, scene, targets);
    Frame frame = frame_of(s, scene, targets);
    const gl::PassScope scope(targets.timers, "views");
    bind_view(frame, view);
    begin_drawing(into.framebuffer, s.size, {.blend = gl::Blend::alpha});
    const gl::Program& program = use_view(frame, view, VIEW_AS_OVERLAY);
    const ViewStats* stats = options.stats_of ? options.stats_of(view) : nullptr;
    set_colours(frame, program, view, shown_range(view, s, scene.scene().bounds, stats), stats);
    glUniform1f(program.uniform("opacity"), static_cast<float>(o.opacity));
    shapes_.draw_fullscreen();
  }
  if (s.view.volumes == VolumeOverlay::off && s.view.object == 0) return;
  Frame frame = frame_of(s, scene, targets);
  const gl::PassScope scope(targets.timers, "views");
  draw_volume_wires(frame, into);
  draw_outline(frame, into);
}

void Renderer::draw_numbers(View view, const Settings& s, const GpuScene& scene, Targets& targets,
                            const PixelGrid& pixels, const ViewOptions& options) {
  count_for(view, s, scene, targets);
  Frame frame = frame_of(s, scene, targets);
  Canvas& canvas = targets.canvases.numbers(pixels.count);
  if (needs_truth(view)) return draw_truth_numbers(frame, view, options, pixels, canvas);
  bind_view(frame, view);
  begin_drawing(canvas.framebuffer, pixels.count, {});
  const gl::Program& program = use_view(frame, view, VIEW_AS_NUMBERS);
  set_pixel_grid(program, s.size, pixels);
  const glm::vec2 cells = cells_per_pixel(frame);
  glUniform2f(program.find_uniform("cells_per_pixel"), cells.x, cells.y);
  shapes_.draw_fullscreen();
}

}  // namespace gbl
