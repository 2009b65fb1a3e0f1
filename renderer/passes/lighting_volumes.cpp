// One sphere mesh per light, one draw each; which faces are drawn is the lesson of lights.cull. A spot light's sphere
// contains its cone; a light without end is drawn over the whole screen.
#include "renderer/light_volume.h"
#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

gl::Cull culled(Faces drawn) {
  switch (drawn) {
    case Faces::front: return gl::Cull::back;
    case Faces::back: return gl::Cull::front;
    case Faces::both: return gl::Cull::off;
  }
  return gl::Cull::off;
}

const gl::Program& volume_program(const LightingPass& pass, bool whole_screen) {
  gl::Defines defines = pass.defines();
  defines.push_back({"CLIP_PLANES", pass.frame.settings.lights.volume.clip == VolumeClip::planes});
  defines.push_back({"WHOLE_SCREEN", whole_screen});
  return pass.frame.programs.get("light_volume.vert", "light_volume.frag", defines);
}

int draw_bounded(const LightingPass& pass) {
  const Frame& frame = pass.frame;
  const Settings& s = frame.settings;
  const gl::Program& program = volume_program(pass, false);
  const Sphere& sphere = frame.shapes.sphere(s.lights.volume.level);
  const double scale = volume_scale(s);
  const double near_corner = s.camera.near * near_corner_factor(s.camera, frame.aspect);
  glUseProgram(program.id());
  glUniform1f(program.uniform("volume_scale"), static_cast<float>(scale));
  glBindVertexArray(sphere.solid.id());
  const GLint index = program.uniform("light_index");
  const std::vector<Light>& lights = frame.targets.lights;
  int draws = 0;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (!bounded(lights[i])) continue;
    const double distance = glm::distance(lights[i].position, s.camera.position);
    gl::apply_cull(culled(faces_to_draw(s.lights.cull, distance, lights[i].range, scale, near_corner)));
    glUniform1i(index, static_cast<GLint>(i));
    glDrawElements(GL_TRIANGLES, sphere.triangle_indices, GL_UNSIGNED_INT, nullptr);
    ++draws;
  }
  return draws;
}

int draw_endless(const LightingPass& pass) {
  const std::vector<Light>& lights = pass.frame.targets.lights;
  int draws = 0;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (bounded(lights[i])) continue;
    const gl::Program& program = volume_program(pass, true);
    glUseProgram(program.id());
    gl::apply_cull(gl::Cull::off);
    glUniform1i(program.uniform("light_index"), static_cast<GLint>(i));
    pass.frame.shapes.draw_fullscreen();
    ++draws;
  }
  return draws;
}

}  // namespace

int draw_volume_lights(const LightingPass& pass) { return draw_bounded(pass) + draw_endless(pass); }

}  // namespace gbl
