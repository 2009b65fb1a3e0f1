#pragma once
// Small solids for the built-in scenes. Every mesh that leaves here has unit normals, unit tangents orthogonal to
// them with w = +1 or -1, and triangles counter-clockwise seen from outside. v runs down the picture as in glTF, so
// the bitangent w * cross(normal, tangent) points towards -v.
#include <array>
#include <glm/glm.hpp>
#include <span>

#include "renderer/scene/scene.h"

namespace gbl {

// Which part of a texture a solid shows: uv * scale + offset. Both scales are positive: no mirrored text.
struct UvPart {
  glm::dvec2 offset{0}, scale{1};
};

// Corner i lies at (i & 1, i & 2, i & 4) of a right-handed box; faces are flat and have corners of their own.
// u and v are lengths on the face times uv_per_unit, from uv_start at its lower left corner.
Mesh make_hexahedron(const std::array<glm::dvec3, 8>& corners, double uv_per_unit, glm::dvec2 uv_start = {0, 0});

Mesh make_box(glm::dvec3 low, glm::dvec3 high, double uv_per_unit, glm::dvec2 uv_start = {0, 0});

// Turns a profile {radius, y}, given from bottom to top, about +Y: cylinders, cones, barrels, lamps. Bends of more
// than 40 degrees are edges, others are smooth. u goes once round from +X (over -Z), v from 1 (bottom) to 0 (top).
Mesh make_lathe(std::span<const glm::dvec2> profile, int sides);

Mesh make_ellipsoid(glm::dvec3 radii, int sides, int rings);

// An ellipsoid pushed in and out by at most `roughness` of its radius; flat facets.
Mesh make_boulder(glm::dvec3 radii, double roughness, uint64_t seed, double uv_per_unit);

// to_from_part may scale unevenly but not mirror.
void append(Mesh& to, const Mesh& part, const glm::dmat4& to_from_part, const UvPart& uv = {});

// Fills in every tangent from positions, normals and uv.
void set_tangents(Mesh&);

// Moves the part from standing on the origin along +Y to reaching from `from` towards `to` (its length is kept).
glm::dmat4 pointing(glm::dvec3 from, glm::dvec3 to);

}  // namespace gbl
