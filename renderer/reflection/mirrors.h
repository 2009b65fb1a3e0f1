#pragma once
// Which objects of a scene mirror it, and from where each must be looked at: a flat one from behind its plane, any other from
// its middle towards six sides.
#include <glm/glm.hpp>
#include <vector>

#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace gbl {

inline constexpr float kMirrorRoughness = 0.2f;  // up to which a reflection is taken for sharp
inline constexpr size_t kMostMirrors = 8;        // that a frame draws; the reference knows no limit

// Lit, and everywhere as smooth as that: what is opaque mirrors the scene, what is clear refracts it, too.
bool refracts(const Material&);
bool is_mirror(const Material&);
// Drawn over the lit picture, and stored in no G-buffer: what is clear is stored where settings let it refract.
bool blends(const Material&, bool refraction);

// Points p of the world with dot(normal, p) = offset; the normal is of length 1 and leads to the side that is seen.
struct Plane {
  glm::dvec3 normal{0, 1, 0};
  double offset = 0;
  double distance(const glm::dvec3& p) const { return glm::dot(normal, p) - offset; }
};

struct Mirror {
  int object = 0;  // from 1, as SeenSurface counts
  bool flat = false;
  bool clear = false;  // it refracts
  bool two_sided = false;
  Plane plane;           // of a flat one
  glm::dvec3 centre{0};  // of its box, in the world
  double radius = 0;     // half the box's shortest side
};

// In the order of the scene's instances.
std::vector<Mirror> mirrors_of(const Scene&);

// Of a flat one that both sides of are drawn: the side that the camera is on.
Plane facing(const Plane&, const Camera&);
// Is its front seen?
bool faces(const Plane&, const Camera&);

// The camera that sees, turned about its vertical axis, what this one sees in the mirror: columns run the other way, and no
// triangle's winding is flipped.
Camera mirrored(const Camera&, const Plane&);

// A square view of one side, as shaders/cube.glsl chooses sides. Its outermost texels lie beyond the side's edge, so that a
// filter finds its neighbours.
Camera side_camera(const Mirror&, int side, int texels, const Camera& like);
double side_tangent(int texels);  // of half that view's angle

}  // namespace gbl
