// One sphere mesh per light, one draw each; which faces are drawn is the lesson of lights.cull.
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

}  // namespace

int draw_volume_lights(const LightingPass& pass) {
  const Frame& frame = pass.frame;
  const Settings& s = frame.settings;
  gl::Defines defines = pass.defines();
  defines.push_back({"CLIP_PLANES", s.lights.volume.clip == VolumeClip::planes});
  const gl::Program& program = frame.programs.get("light_volume.vert", "light_volume.frag", defines);
  const Sphere& sphere = frame.shapes.sphere(s.lights.volume.level);
  const double scale = volume_scale(s);
  const double near_corner = s.camera.near * near_corner_factor(s.camera, frame.aspect);
  glUseProgram(program.id());
  glUniform1f(program.uniform("volume_scale"), static_cast<float>(scale));
  glBindVertexArray(sphere.solid.id());
  const GLint index = program.uniform("light_index");
  const std::vector<Light>& lights = frame.targets.lights;
  for (size_t i = 0; i < lights.size(); ++i) {
    const double distance = glm::distance(lights[i].position, s.camera.position);
    gl::apply_cull(culled(faces_to_draw(s.lights.cull, distance, lights[i].range, scale, near_corner)));
    glUniform1i(index, static_cast<GLint>(i));
    glDrawElements(GL_TRIANGLES, sphere.triangle_indices, GL_UNSIGNED_INT, nullptr);
  }
  return static_cast<int>(lights.size());
}

}  // namespace gbl
