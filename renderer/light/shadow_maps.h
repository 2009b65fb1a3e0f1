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

struct ShadowMap {
  int light = 0;                     // index into the frame's lights
  glm::dmat4 clip_from_anchored{1};  // relative to the plan's anchor, world axes; depth -1..1
  double texel = 0;                  // world units: of a perspective map at distance 1 along its axis
  bool orthographic = false;         // a sun's
  double up_to = 0;                  // a sun's: from this distance along the view axis on the next cascade holds
  glm::ivec2 corner{0};              // of its tile in the texture, texels
};

// What a map holds depends on nothing but its matrix and the scene: the anchor is the scene's, not the camera's, so that a map
// serves until its light moves, and its bits are the same wherever the camera was when it was drawn.
struct ShadowPlan {
  glm::dvec3 anchor{0};  // in the world: the middle of the scene
  std::vector<ShadowMap> maps;
  std::vector<int> first_map;  // of each of the frame's lights; -1: none
  int map_texels = 0;          // to a side
  glm::ivec2 size{0};          // of the texture
  int with = 0, without = 0;   // lights that should have maps, and have or have not
};

struct ShadowWishes {
  int map_texels = 1024, cascades = 3, most_lights = 8;
  bool suns_only = false;
  bool stable = true;           // a sun's maps move by whole texels, and their size follows no turn of the camera
  bool near_one = false;        // maps of points and spots from 1 unit to 1.5 ranges, as the engine blog has them
  bool up_is_always_y = false;  // Mistake::cube_lookat_up
};

// Suns come first, then the others in their order.
ShadowPlan plan_shadows(std::span<const Light>, const Camera&, double aspect, const Bounds& scene, const ShadowWishes&);

// The maps of one light alone, which then is the only light of the frame.
void keep_only(ShadowPlan&, size_t light);

// For places relative to the camera, which is at this place in the world.
glm::dmat4 clip_from_relative(const ShadowPlan&, const ShadowMap&, const glm::dvec3& camera);

// False where nothing in this box of the world can be drawn into the map.
bool may_hide(const ShadowMap&, const glm::dvec3& anchor, const Bounds&);

// A map whose matrix is not finite is not drawn, and hides nothing.
bool is_finite(const glm::dmat4&);

// Where cascades end along the view axis, from near to far: half way between equal parts and equal ratios (Zhang et al. 2006,
// "Parallel-Split Shadow Maps for Large-scale Virtual Environments").
std::vector<double> cascade_ends(double near, double far, int count);

// The rotation of a cube's face, as the shader chooses faces: +X, -X, +Y, -Y, +Z, -Z. up_is_always_y: as the engine blog prints
// it, where two faces look along their up vector.
glm::dmat3 view_of_cube_face(int face, bool up_is_always_y = false);  // view from world

}  // namespace gbl
