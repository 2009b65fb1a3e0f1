// All volumes of a shape in one draw; a rule that flips takes two, with opposite culling, and in each the vertex shader
// leaves out the lights that belong to the other. No lists: an instance's number is its light's.
#include "renderer/passes/frame_block.h"
#include "renderer/passes/volumes.h"

namespace gbl {
namespace {

int draw_shape(const LightingPass& pass, VolumeShape shape) {
  const Frame& frame = pass.frame;
  if (!any_light(frame, shape)) return 0;
  const gl::Program& program = use_volume_program(pass, shape, VolumeDraw::all_lights);
  const GpuVolume& mesh = frame.shapes.volume(shape, frame.settings.lights.volume.level);
  const CullRule rule = cull_rule(frame);
  gl::change(volume_state(frame));
  glBindVertexArray(mesh.solid.id());
  glUniform1i(program.uniform("inside_the_mesh"), rule.by_mesh);
  glUniform1f(program.uniform("inside_margin"), static_cast<float>(rule.margin));
  const auto draw = [&](int kept, Faces faces) {
    gl::apply_cull(culled(faces));
    glUniform1i(program.uniform("kept_lights"), kept);
    glDrawElementsInstanced(GL_TRIANGLES, mesh.triangle_indices, GL_UNSIGNED_INT, nullptr, frame.light_count());
    return 1;
  };
  if (rule.inside == rule.outside) return draw(KEEP_ALL, rule.inside);
  return draw(KEEP_INSIDE, rule.inside) + draw(KEEP_OUTSIDE, rule.outside);
}

int draw_endless(const LightingPass& pass) {
  if (!any_light(pass.frame, VolumeShape::screen)) return 0;
  const gl::Program& program = use_volume_program(pass, VolumeShape::screen, VolumeDraw::all_lights);
  gl::change(endless_state(pass.frame));
  glUniform1i(program.uniform("kept_lights"), KEEP_ALL);
  pass.frame.shapes.draw_fullscreen(pass.frame.light_count());
  return 1;
}

}  // namespace

int draw_volume_lights_instanced(const LightingPass& pass) {
  int draws = 0;
  for (const VolumeShape shape : kMeshShapes) draws += draw_shape(pass, shape);
  return draws + draw_endless(pass);
}

}  // namespace gbl
