#pragma once
// Which shadow maps a frame has, and where each looks: a sun has some cascades, a spot one map, a point light six. All maps
// lie side by side in one depth texture.
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace gbl {

inline constexpr int kMostShadowTexels = 8192;  // to a side of the texture that holds all maps
inline constexpr int kCubeFaces = 6;
inline constexpr double kShadowNearShare = 1e-3;  // the near plane of a point or spot light's map, of its far plane

struct ShadowMap {
  int light = 0;                     // index into the frame's lights
  glm::dmat4 clip_from_relative{1};  // relative to the camera, world axes; depth -1..1
  double texel = 0;                  // world units: of a perspective map at distance 1 along its axis
  bool orthographic = false;         // a sun's
  double up_to = 0;                  // a sun's: from this distance along the view axis on the next cascade holds
  glm::ivec2 corner{0};              // of its tile in the texture, texels
};

struct ShadowPlan {
  std::vector<ShadowMap> maps;
  std::vector<int> first_map;  // of each of the frame's lights; -1: none
  int map_texels = 0;          // to a side
  glm::ivec2 size{0};          // of the texture
  int with = 0, without = 0;   // lights that should have maps, and have or have not
};

struct ShadowWishes {
  int map_texels = 1024, cascades = 3, most_lights = 8;
  bool suns_only = false;
};

// Suns come first, then the others in their order.
ShadowPlan plan_shadows(std::span<const Light>, const Camera&, double aspect, const Bounds& scene, const ShadowWishes&);

// The maps of one light alone, which then is the only light of the frame.
void keep_only(ShadowPlan&, size_t light);

// False where nothing in this box of the world can be drawn into the map. camera: its place in the world.
bool may_hide(const ShadowMap&, const glm::dvec3& camera, const Bounds&);

// Where cascades end along the view axis, from near to far: half way between equal parts and equal ratios (Zhang et al. 2006,
// "Parallel-Split Shadow Maps for Large-scale Virtual Environments").
std::vector<double> cascade_ends(double near, double far, int count);

// The rotation of a cube's face, as the shader chooses faces: +X, -X, +Y, -Y, +Z, -Z.
glm::dmat3 view_of_cube_face(int face);  // view from world

}  // namespace gbl
