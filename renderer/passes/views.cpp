// The pictures for the eye, and the wires over them. Look; do not touch: what they read is never changed.
#include "renderer/inspect/views.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

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

void Renderer::draw_view(View view, const Settings& s, const GpuScene& scene, Targets& targets, ViewOptions options) {
  if (counted(view) && !targets.canvases.counts_valid) count_pairs(s, scene, targets, false);
  Frame frame = frame_of(s, scene, targets);
  if (needs_truth(view)) return draw_truth_view(frame, view, options, targets.canvases.view(view));
  gl::Defines defines = frame.defines();
  defines.push_back({"SPLIT", frame.resolved.split});
  defines.push_back({"VIEW_FILE", shader_of(view)});
  defines.push_back({"RAW", options.raw});
  const gl::Program& program = programs_.get("fullscreen.vert", "views.frag", defines);
  Canvas& canvas = targets.canvases.view(view);
  const gl::PassScope scope(targets.timers, "views");
  begin_drawing(canvas.framebuffer, s.size, {});
  bind_gbuffer(frame);
  bind_light_sums(frame);
  gl::bind_texture("lit",
                   row(view).with_transparent ? targets.canvases.shown(targets.frame) : frame.texture(Stores::lit));
  if (counted(view)) gl::bind_texture("counts", targets.canvases.counts().texture);
  glUseProgram(program.id());
  glUniform3fv(program.find_uniform("empty_colour"), 1, glm::value_ptr(row(view).empty_colour));
  glUniform1iv(program.find_uniform("wasted_from"), kLightCountColours, kWastedFrom);
  glUniform3fv(program.find_uniform("count_palette"), kLightCountColours, glm::value_ptr(kLightCountPalette[0]));
  shapes_.draw_fullscreen();
  if (options.overlays) {
    draw_volume_wires(frame, canvas);
    draw_outline(frame, canvas);
  }
}

}  // namespace gbl
