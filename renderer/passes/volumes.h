#pragma once
// What the methods of light volumes share: meshes, programs and states. Spheres first, then the cones of spots; lights
// without end come last, over the whole screen.
#include "renderer/passes/lighting.h"

namespace gbl {

inline constexpr VolumeShape kMeshShapes[] = {VolumeShape::sphere, VolumeShape::cone};

bool any_light(const Frame&, VolumeShape);
CullRule cull_rule(const Frame&);
gl::Cull culled(Faces drawn);

// The state of a draw that shades: light is added, depth is compared as lights.volume.depth says.
gl::PassState volume_state(const Frame&);
gl::PassState endless_state(const Frame&);

// Made current, with its uniforms set but for those of the light.
enum class VolumeDraw { one_light, all_lights, marks };
const gl::Program& use_volume_program(const LightingPass&, VolumeShape, VolumeDraw);

// What places a mesh in light_proxy.glsl. depth_step: see volume_depth_step().
void set_mesh_uniforms(const gl::Program&, const Settings&, VolumeShape, double depth_step);

int draw_endless_lights(const LightingPass&);  // one draw each -> draw calls

}  // namespace gbl
