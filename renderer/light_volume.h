#pragma once
// Light volume meshes. A proxy contains its volume; if in doubt it is larger.
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/scene.h"
#include "renderer/settings.h"

namespace gbl {

// Has the light an end, so that a volume can hold it?
inline bool bounded(const Light& l) { return l.kind != LightKind::directional && l.range < kEndless; }

struct VolumeMesh {
  std::vector<glm::vec3> vertices;  // on the unit sphere
  std::vector<uint32_t> triangles;  // counter-clockwise from outside
  std::vector<uint32_t> edges;      // pairs, each edge once: the wire
  double inradius = 1;              // distance from the centre to the nearest face, < 1
};

// Icosphere: the icosahedron with each face split in four `level` times (0…4).
VolumeMesh icosphere(int level);

// Factor on a light's range for the mesh's vertices: 1 inscribed, 1/inradius circumscribed.
double volume_scale(const Settings&);

enum class Faces { front, back, both };  // which faces of a volume are drawn
// camera_distance: from the camera to the light's centre. near_corner: distance to the near plane's corner.
Faces faces_to_draw(LightCull, double camera_distance, double range, double scale, double near_corner);

}  // namespace gbl
