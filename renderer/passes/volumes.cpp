#include "renderer/passes/volumes.h"

#include <algorithm>

namespace gbl {

bool any_light(const Frame& frame, VolumeShape shape) {
  const std::vector<Light>& lights = frame.lights();
  return std::any_of(lights.begin(), lights.end(), [&](const Light& l) { return volume_shape(l) == shape; });
}

CullRule cull_rule(const Frame& frame) {
  const Camera& camera = frame.settings.camera;
  return cull_rule(frame.settings.lights.cull, camera.near * near_corner_factor(camera, frame.resolved.aspect));
}

gl::Cull culled(Faces drawn) {
  switch (drawn) {
    case Faces::front: return gl::Cull::back;
    case Faces::back: return gl::Cull::front;
    case Faces::both: return gl::Cull::off;
  }
  return gl::Cull::off;
}

gl::PassState volume_state(const Frame& frame) {
  const auto& volume = frame.settings.lights.volume;
  gl::PassState state = endless_state(frame);
  switch (volume.depth) {
    case VolumeDepth::none: return state;
    case VolumeDepth::less_equal: state = depth_tested(frame, gl::DepthTest::less_equal, state); break;
    case VolumeDepth::greater_equal: state = depth_tested(frame, gl::DepthTest::greater_equal, state); break;
  }
  state.depth_clamp = volume.clip == VolumeClip::none;
  return state;
}

gl::PassState endless_state(const Frame& frame) {
  return depth_tested(frame, gl::DepthTest::off, {.blend = gl::Blend::add, .stencil = light_stencil(frame)});
}

void set_mesh_uniforms(const gl::Program& program, const Settings& s, VolumeShape shape, double depth_step) {
  glUniform1f(program.find_uniform("volume_scale"),
              static_cast<float>(volume_scale(s.lights.volume.fit, s.lights.volume.level, shape)));
  glUniform1f(program.find_uniform("depth_step"), static_cast<float>(depth_step));
}

const gl::Program& use_volume_program(const LightingPass& pass, VolumeShape shape, VolumeDraw draw) {
  const Settings& s = pass.frame.settings;
  const bool true_depth = pass.frame.resolved.lighting_tests_depth || s.lights.volume.clip == VolumeClip::planes;
  gl::Defines defines = pass.defines();
  defines.push_back({"SHAPE", static_cast<int>(shape)});
  defines.push_back({"INSTANCED", draw == VolumeDraw::all_lights});
  defines.push_back({"TRUE_DEPTH", true_depth && shape != VolumeShape::screen});
  const char* fragment = draw == VolumeDraw::marks ? "light_mark.frag" : "light_volume.frag";
  const gl::Program& program = pass.frame.programs.get("light_volume.vert", fragment, defines);
  glUseProgram(program.id());
  set_mesh_uniforms(program, s, shape, pass.frame.resolved.volume_depth_step);
  return program;
}

int draw_endless_lights(const LightingPass& pass) {
  if (!any_light(pass.frame, VolumeShape::screen)) return 0;
  const std::vector<Light>& lights = pass.frame.lights();
  const gl::Program& program = use_volume_program(pass, VolumeShape::screen, VolumeDraw::one_light);
  gl::change(endless_state(pass.frame));
  int draws = 0;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (bounded(lights[i])) continue;
    glUniform1i(program.uniform("light_index"), static_cast<GLint>(i));
    pass.frame.shapes.draw_fullscreen();
    ++draws;
  }
  return draws;
}

}  // namespace gbl
