#pragma once
// What the built-in scenes are put together from: adding by value, placing, and larger solids than mesh_builder's.
#include <functional>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/scenes/surface_textures.h"

namespace gbl {

// Each returns the index of what was added.
int add(Scene&, Texture);
int add(Scene&, Material);
int add(Scene&, Mesh, const char* name);
// Adds the three textures and the material that reads them; `m` brings name and factors.
int add(Scene&, SurfaceTextures, Material m);
// … and its height map, on what has so many texture coordinates to a world unit. deeper: than the normal map's slopes ask,
// so that it can be seen from some metres away.
int add_relief(Scene&, SurfaceTextures, Material m, double uv_per_unit, double deeper = 1);

void place(Scene&, std::string name, int mesh, int material, const glm::dmat4& world_from_object = glm::dmat4(1));
// A mesh that stands once, in world coordinates.
void place(Scene&, const char* name, Mesh, int material);

// Standing on the ground at a place, turned about +Y (positive: to the left, as a camera's yaw).
glm::dmat4 standing_at(glm::dvec3 place, double yaw_deg = 0, double scale = 1);

Camera camera_at(glm::dvec3 position, double yaw_deg, double pitch_deg, double fov, double near, double far);

// A rectangle from its lower left corner, seen from the side that cross(right, up) points to; u runs along right, v
// down; cut into columns x rows.
Mesh make_sheet(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, double uv_per_unit, glm::ivec2 cells = {1, 1});

// A box with rounded edges, each of `steps` bends; uv as make_box.
Mesh make_rounded_box(glm::dvec3 low, glm::dvec3 high, double radius, int steps, double uv_per_unit,
                      glm::dvec2 uv_start = {0, 0});

// A round bar through all the points, open at its ends; u goes round, v along.
Mesh make_tube(std::span<const glm::dvec3> points, double radius, int sides);

// Ground over the lines x (left to right) and z (far to near) of a grid, smooth; u runs along +X, v along +Z.
Mesh make_ground(const std::vector<double>& x, const std::vector<double>& z,
                 const std::function<double(double x, double z)>& height, double uv_per_unit);

// The same solid with u and v counted `times` as often: make_lathe spans a texture once.
Mesh retiled(const Mesh&, glm::dvec2 times);

}  // namespace gbl
