// One mesh per light, one draw each; which faces are drawn is the lesson of lights.cull.
#include "renderer/passes/volumes.h"

namespace gbl {
namespace {

int draw_shape(const LightingPass& pass, VolumeShape shape) {
  const Frame& frame = pass.frame;
  const Settings& s = frame.settings;
  if (!any_light(frame, shape)) return 0;
  const gl::Program& program = use_volume_program(pass, shape, VolumeDraw::one_light);
  const GpuVolume& mesh = frame.shapes.volume(shape, s.lights.volume.level);
  gl::change(volume_state(frame));
  glBindVertexArray(mesh.solid.id());
  const CullRule rule = cull_rule(frame);
  const double scale = volume_scale(s.lights.volume.fit, s.lights.volume.level, shape);
  const GLint index = program.uniform("light_index");
  const std::vector<Light>& lights = frame.lights();
  int draws = 0;
  for (size_t i = 0; i < lights.size(); ++i) {
    const Light& l = lights[i];
    if (volume_shape(l) != shape) continue;
    const double distance = glm::distance(l.position, s.camera.position);
    gl::apply_cull(culled(faces_to_draw(rule, distance, l.range, volume_reach(l, scale, 0))));
    glUniform1i(index, static_cast<GLint>(i));
    glDrawElements(GL_TRIANGLES, mesh.triangle_indices, GL_UNSIGNED_INT, nullptr);
    ++draws;
  }
  return draws;
}

}  // namespace

int draw_volume_lights(const LightingPass& pass) {
  int draws = 0;
  for (const VolumeShape shape : kMeshShapes) draws += draw_shape(pass, shape);
  return draws + draw_endless_lights(pass);
}

}  // namespace gbl
