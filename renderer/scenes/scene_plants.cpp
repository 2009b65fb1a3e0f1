#include "renderer/scenes/scene_plants.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <tuple>
#include <vector>

#include "renderer/base/random.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/scenes/procedural_texture.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

using Profile = std::vector<glm::dvec2>;

// Normals of a surface that was bent: the mean over the triangles that meet at a place, seams included.
void set_smooth_normals(Mesh& mesh) {
  const auto key = [](glm::vec3 p) { return std::make_tuple(p.x, p.y, p.z); };
  std::map<std::tuple<float, float, float>, glm::dvec3> sums;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 a = mesh.vertices[mesh.indices[i]].position, b = mesh.vertices[mesh.indices[i + 1]].position;
    const glm::vec3 c = mesh.vertices[mesh.indices[i + 2]].position;
    const glm::dvec3 face = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
    for (const glm::vec3& p : {a, b, c}) sums[key(p)] += face;
  }
  for (Vertex& v : mesh.vertices) v.normal = glm::normalize(sums[key(v.position)]);
  set_tangents(mesh);
}

// Pushes the vertices of a lathe outwards by up to `depth` of their distance from the axis.
void make_uneven(Mesh& mesh, double depth, uint64_t seed, double v_per_unit) {
  const TileNoise noise(seed);
  for (Vertex& v : mesh.vertices) {
    const double u = v.uv.x < 1 ? v.uv.x : 0;  // both sides of the seam move alike
    const double push = 1 + depth * noise.fractal(u, v.position.y * v_per_unit, 5, 2);
    v.position = glm::dvec3(v.position) * glm::dvec3(push, 1, push);
  }
  set_smooth_normals(mesh);
}

void add_bough(Mesh& to, glm::dvec3 from, glm::dvec3 end, double radius) {
  const double length = glm::distance(from, end);
  const Profile profile = {{radius, 0}, {radius * 0.75, length * 0.5}, {radius * 0.35, length}};
  append(to, make_lathe(profile, 7), pointing(from, end), {{0, 0}, {1, length * 0.5}});
}

}  // namespace

Tree make_tree(const TreeShape& s) {
  Tree tree;
  tree.wood.name = "wood";
  tree.foliage.name = "foliage";
  const double top = s.trunk + (s.height - s.trunk) * 0.55;
  const Profile trunk = {{s.radius * 2.1, -0.3},    {s.radius * 1.5, 0.05},     {s.radius * 1.15, s.trunk * 0.2},
                         {s.radius, s.trunk * 0.6}, {s.radius * 0.85, s.trunk}, {s.radius * 0.35, top}};
  Mesh stem = make_lathe(trunk, 11);
  make_uneven(stem, 0.16, s.seed, 0.25);
  append(tree.wood, stem, glm::dmat4(1), {{0, 0}, {1, 0.5 * top}});

  Pcg32 rng(s.seed);
  const double half = (s.height - s.trunk) / 2, middle = s.trunk + half;
  for (int i = 0; i < s.rounds; ++i) {
    // Turned by the golden angle from bottom to top, so that any number of rounds is spread evenly.
    const double t = (i + 0.5) / s.rounds, angle = i * 2.399963 + rng.in(-0.3, 0.3);
    const double reach = i + 1 == s.rounds ? 0 : s.crown * 0.58 * std::sqrt(1 - (2 * t - 1) * (2 * t - 1) * 0.9);
    const double size = s.crown * rng.in(0.46, 0.6);
    const double y = middle + (2 * t - 1) * (half - size * 0.8);
    const glm::dvec3 centre(reach * std::cos(angle), y, reach * std::sin(angle));
    const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1), centre), rng.in(0, 6), {0, 1, 0});
    Mesh round =
        make_lathe(Profile{{0, -0.78}, {0.5, -0.66}, {0.86, -0.36}, {1, 0}, {0.9, 0.38}, {0.55, 0.7}, {0, 0.84}}, 11);
    make_uneven(round, 0.2, s.seed * 31 + static_cast<uint64_t>(i), 0.5);
    append(tree.foliage, round, glm::scale(turned, glm::dvec3(size)), {{rng.unit(), rng.unit()}, {2, 1}});
    if (i % 2 == 0 && reach > 0) add_bough(tree.wood, {0, s.trunk * 0.75 + half * 0.5 * t, 0}, centre, s.radius * 0.4);
  }
  return tree;
}

Mesh make_old_trunk(double height, double radius, uint64_t seed) {
  Profile profile;
  constexpr int kRings = 26, kSides = 40;
  for (int i = 0; i <= kRings; ++i) {
    const double y = -0.25 + (height + 0.25) * i / kRings;
    const double roots = std::exp(-std::max(y, -0.1) * 2.2 / radius * 0.5);
    profile.emplace_back(radius * (0.92 + 0.75 * roots - 0.1 * y / height), y);
  }
  Mesh trunk = make_lathe(profile, kSides);
  const TileNoise noise(seed);
  for (Vertex& v : trunk.vertices) {  // roots: lobes that fade upwards
    const double u = v.uv.x < 1 ? v.uv.x : 0, y = v.position.y;
    const double low = std::exp(-std::max(y, 0.0) * 1.4 / radius * 0.5);
    const double lobes = noise.at(u, 0.31 + 0.02 * y, 6) * (0.16 + 0.55 * low);
    const double push = 1 + lobes + 0.1 * noise.fractal(u, y * 0.2, 9, 2);
    v.position = glm::dvec3(v.position) * glm::dvec3(push, 1, push);
  }
  set_smooth_normals(trunk);
  Mesh out;
  append(out, trunk, glm::dmat4(1), {{0, 0}, {2, height / (glm::pi<double>() * radius)}});
  out.name = "trunk";
  return out;
}

}  // namespace gbl
