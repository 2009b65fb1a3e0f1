#pragma once
// Tangents for a normal map, the way of Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", whose code
// (MikkTSpace) baked most maps: per face corner, each face's direction of +u laid into the corner's normal plane,
// weighted by the corner's angle, summed over corners of equal position, normal, uv and orientation.
//
// Own code. Where it differs from MikkTSpace:
// - corners that are equal share a tangent even when their faces share no edge (MikkTSpace walks edges);
// - equal means equal bits, and triangles stand for themselves (quads are not put together);
// - a corner without area in uv takes its neighbours' tangent, of its own corner only, else any direction.
#include <glm/glm.hpp>

#include "renderer/scene/scene.h"

namespace gbl {

// Sets every tangent. A vertex where both orientations of uv meet becomes two. uv_set: 0 or 1; the transform is the
// normal map's own, so that tangents run along the map as it lies on the surface.
void make_tangents(Mesh&, int uv_set = 0, const glm::mat3& uv_transform = glm::mat3(1));

// Any tangent: unit and perpendicular to the normal. For surfaces that no normal map touches.
glm::vec4 any_tangent(const glm::vec3& normal);

}  // namespace gbl
