#pragma once
// Light volume meshes. A proxy contains its volume; if in doubt it is larger.
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/light/light_axes.h"
#include "renderer/scene/scene.h"

namespace gbl {

// Has the light an end, so that a volume can hold it?
inline bool bounded(const Light& l) { return l.kind != LightKind::directional && l.range < kEndless; }

// What stands for a light: its sphere, the cone of a narrow spot, or all pixels for a light without end.
enum class VolumeShape { sphere, cone, screen };
VolumeShape volume_shape(const Light&);

struct VolumeMesh {
  std::vector<glm::vec3> vertices;  // of a unit sphere, or of a cone from the origin to radius 1 at z = 1
  std::vector<uint32_t> triangles;  // counter-clockwise from outside
  std::vector<uint32_t> edges;      // pairs, each edge once: the wire
  double inradius = 1;              // of what the mesh stands for, the part that it holds: scaled by 1/inradius, all
};

// Icosphere: the icosahedron with each face split in four `level` times (0…4).
VolumeMesh icosphere(int level);
VolumeMesh cone(int sides);
VolumeMesh volume_mesh(VolumeShape, VolumeLevel);  // of a sphere or a cone

// Factor on the unit mesh: 1 inscribed, 1/inradius circumscribed.
double volume_scale(VolumeFit, VolumeLevel, VolumeShape);

// Where the shaders put a vertex of the unit mesh, in double and in their float; the farthest is at volume_reach().
glm::dvec3 volume_vertex(const Light&, const glm::dvec3& vertex, double scale, double slack);
glm::vec3 volume_vertex_f32(const Light&, const glm::vec3& vertex, float scale, float slack);
double volume_reach(const Light&, double scale, double slack);

enum class Faces { front, back, both };  // which faces of a volume are drawn

// A culling rule: what is drawn of the lights that the camera is inside and outside of. Inside is who is nearer to the
// light than its range, or than its mesh reaches, plus a margin.
struct CullRule {
  Faces inside, outside;
  bool by_mesh = false;
  double margin = 0;
};
CullRule cull_rule(LightCull, double near_corner);  // near_corner: distance to the near plane's corner

// camera_distance: from the camera to the light's centre. reach: the mesh's.
Faces faces_to_draw(const CullRule&, double camera_distance, double range, double reach);

}  // namespace gbl
