// Two draws per light. The first compares both sides of the volume with the scene's depth and leaves a mark where the
// surface is inside: behind a front face and before a back face. The second shades what is marked and wipes the marks.
// Faces *behind* the surface are counted, so that a camera inside the volume changes nothing, and depth is clamped, so
// that the far plane cuts no back face away. (Everitt and Kilgard 2002, "Practical and Robust Stenciled Shadow Volumes
// for Hardware-Accelerated Rendering".)
#include "renderer/passes/volumes.h"

namespace gbl {
namespace {

gl::PassState marking(const Frame& frame) {
  // "equal" passes: the far plane is behind no surface
  return depth_tested(frame, gl::DepthTest::less_equal,
                      {.colour_write = false, .depth_clamp = true, .stencil = gl::Stencil::count_hidden});
}

// Every marked pixel has one back face.
gl::PassState shading(const Frame& frame) {
  gl::PassState state = endless_state(frame);
  state.cull = gl::Cull::front;
  state.depth_clamp = true;
  state.stencil = gl::Stencil::take_marked;
  return state;
}

int draw_shape(const LightingPass& pass, VolumeShape shape) {
  const Frame& frame = pass.frame;
  if (!any_light(frame, shape)) return 0;
  const gl::Program& mark = use_volume_program(pass, shape, VolumeDraw::marks);
  const gl::Program& shade = use_volume_program(pass, shape, VolumeDraw::one_light);
  const GpuVolume& mesh = frame.shapes.volume(shape, frame.settings.lights.volume.level);
  glBindVertexArray(mesh.solid.id());
  const auto draw = [&](const gl::PassState& state, const gl::Program& program, size_t light) {
    gl::change(state);
    glUseProgram(program.id());
    glUniform1i(program.uniform("light_index"), static_cast<GLint>(light));
    glDrawElements(GL_TRIANGLES, mesh.triangle_indices, GL_UNSIGNED_INT, nullptr);
    return 1;
  };
  const std::vector<Light>& lights = frame.lights();
  int draws = 0;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (volume_shape(lights[i]) != shape) continue;
    draws += draw(marking(frame), mark, i);
    draws += draw(shading(frame), shade, i);
  }
  return draws;
}

}  // namespace

int draw_volume_lights_stencil(const LightingPass& pass) {
  int draws = 0;
  for (const VolumeShape shape : kMeshShapes) draws += draw_shape(pass, shape);
  return draws + draw_endless_lights(pass);
}

}  // namespace gbl
