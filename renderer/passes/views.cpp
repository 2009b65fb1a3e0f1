// The pictures for the eye, and the wires over them. Look; do not touch: what they read is never changed.
#include "renderer/views.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/light_volume.h"
#include "renderer/passes/passes.h"

namespace gbl {
namespace {

void draw_wire(const gl::Program& program, const Sphere& sphere, int light) {
  glUniform1i(program.uniform("light_index"), light);
  glDrawElements(GL_LINES, sphere.edge_indices, GL_UNSIGNED_INT, nullptr);
}

// Dark where light is summed, the sky's own colour where a surface is described.
glm::vec3 sky_of(View view) {
  const bool light = view == View::diffuse_light || view == View::specular_light || view == View::lights_per_pixel;
  return light ? glm::vec3(0) : kSkyColour;
}

}  // namespace

void draw_volume_wires(const Frame& frame, Canvas& into) {
  const VolumeOverlay overlay = frame.settings.view.volumes;
  const int lights = static_cast<int>(frame.targets.lights.size());
  if (overlay == VolumeOverlay::off || lights == 0) return;
  const gl::Program& program = frame.programs.get("volume_wire.vert", "volume_wire.frag", frame.defines());
  begin_drawing(into.framebuffer, frame.settings.size, {.blend = gl::Blend::alpha});
  bind_gbuffer(frame);
  bind_lights(frame);
  const Sphere& sphere = frame.shapes.sphere(frame.settings.lights.volume.level);
  glUseProgram(program.id());
  glUniform1f(program.uniform("volume_scale"), static_cast<float>(volume_scale(frame.settings)));
  glBindVertexArray(sphere.wire.id());
  const int picked = std::min(frame.settings.view.pick, lights - 1);
  for (int i = 0; i < lights; ++i)
    if ((overlay == VolumeOverlay::all || i == picked) && bounded(frame.targets.lights[i]))
      draw_wire(program, sphere, i);
}

void Renderer::draw_view(View view, const Settings& s, const GpuScene& scene, Targets& targets, ViewOptions options) {
  if (view == View::lights_per_pixel && !targets.counts_valid) count_pairs(s, scene, targets, false);
  const Frame frame = frame_of(s, scene, targets);
  gl::Defines defines = frame.defines();
  defines.push_back({"SPLIT", frame.split()});
  defines.push_back({"VIEW", static_cast<int>(view)});
  defines.push_back({"RAW", options.raw});
  const gl::Program& program = programs_.get("fullscreen.vert", "views.frag", defines);
  Canvas& canvas = targets.view(view);
  const gl::PassScope scope(targets.timers, "views");
  begin_drawing(canvas.framebuffer, s.size, {});
  bind_gbuffer(frame);
  bind_light_sums(frame);
  gl::bind_texture(kLitUnit, view == View::final ? targets.shown() : *targets.texture(Stores::lit));
  if (view == View::lights_per_pixel) gl::bind_texture(kCountUnit, targets.counts().texture);
  glUseProgram(program.id());
  glUniform3fv(program.uniform("sky_colour"), 1, glm::value_ptr(sky_of(view)));
  glUniform3fv(program.uniform("count_palette"), kLightCountColours, glm::value_ptr(kLightCountPalette[0]));
  shapes_.draw_fullscreen();
  if (options.overlays) {
    draw_volume_wires(frame, canvas);
    draw_outline(frame, canvas);
  }
}

}  // namespace gbl
