#include "renderer/light/light_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>

// The shader's text twice. GLM supplies GLSL's functions; `real` is the one word that differs.
namespace gbl::volume_f32 {
using real = float;
using vec3 = glm::vec3;
using glm::max, glm::sqrt;
#include "shaders/volume_mesh.glsl"
}  // namespace gbl::volume_f32
namespace gbl::volume_f64 {
using real = double;
using vec3 = glm::dvec3;
using glm::max, glm::sqrt;
#include "shaders/volume_mesh.glsl"
}  // namespace gbl::volume_f64

namespace gbl {
namespace {

// The icosahedron: three golden rectangles.
VolumeMesh icosahedron() {
  const double phi = (1 + std::sqrt(5.0)) / 2;
  VolumeMesh m;
  for (const glm::dvec3 v : {glm::dvec3(-1, phi, 0),
                             {1, phi, 0},
                             {-1, -phi, 0},
                             {1, -phi, 0},
                             {0, -1, phi},
                             {0, 1, phi},
                             {0, -1, -phi},
                             {0, 1, -phi},
                             {phi, 0, -1},
                             {phi, 0, 1},
                             {-phi, 0, -1},
                             {-phi, 0, 1}})
    m.vertices.push_back(glm::vec3(glm::normalize(v)));
  m.triangles = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                 3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
  return m;
}

void split_faces(VolumeMesh& m) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [it, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(m.vertices.size()));
    if (fresh) m.vertices.push_back(glm::vec3(glm::normalize(glm::dvec3(m.vertices[a]) + glm::dvec3(m.vertices[b]))));
    return it->second;
  };
  std::vector<uint32_t> finer;
  for (size_t t = 0; t < m.triangles.size(); t += 3) {
    const uint32_t a = m.triangles[t], b = m.triangles[t + 1], c = m.triangles[t + 2];
    const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
  }
  m.triangles = std::move(finer);
}

double inradius(const VolumeMesh& m) {
  double nearest = 1;
  for (size_t t = 0; t < m.triangles.size(); t += 3) {
    const glm::dvec3 a(m.vertices[m.triangles[t]]), b(m.vertices[m.triangles[t + 1]]),
        c(m.vertices[m.triangles[t + 2]]);
    nearest = std::min(nearest, glm::dot(glm::normalize(glm::cross(b - a, c - a)), a));
  }
  return nearest;
}

std::vector<uint32_t> edges_of(const VolumeMesh& m) {
  std::vector<uint32_t> edges;
  for (size_t t = 0; t < m.triangles.size(); t += 3)
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = m.triangles[t + k], b = m.triangles[t + (k + 1) % 3];
      if (a < b) edges.insert(edges.end(), {a, b});  // its other face has b < a
    }
  return edges;
}

}  // namespace

VolumeMesh icosphere(int level) {
  VolumeMesh m = icosahedron();
  for (int i = 0; i < level; ++i) split_faces(m);
  m.inradius = inradius(m);
  m.edges = edges_of(m);
  return m;
}

// A fan about the apex, a fan about the base's middle.
VolumeMesh cone(int sides) {
  VolumeMesh m;
  m.vertices = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * glm::pi<double>() * i / sides;
    m.vertices.emplace_back(std::cos(turn), std::sin(turn), 1);
  }
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<uint32_t>(2 + i), b = static_cast<uint32_t>(2 + (i + 1) % sides);
    m.triangles.insert(m.triangles.end(), {0, b, a, 1, a, b});
    m.edges.insert(m.edges.end(), {0, a, 1, a, a, b});
  }
  m.inradius = std::cos(glm::pi<double>() / sides);
  return m;
}

VolumeMesh volume_mesh(VolumeShape shape, VolumeLevel level) {
  constexpr int kSides[] = {8, 12, 18, 24, 36};
  const int l = static_cast<int>(level);
  return shape == VolumeShape::cone ? cone(kSides[l]) : icosphere(l);
}

// A cone grows without end towards 90 degrees; at 60 its base is wider than the sphere.
VolumeShape volume_shape(const Light& l) {
  if (!bounded(l)) return VolumeShape::screen;
  return l.kind == LightKind::spot && l.outer_cos > 0.5 ? VolumeShape::cone : VolumeShape::sphere;
}

double volume_scale(VolumeFit fit, VolumeLevel level, VolumeShape shape) {
  if (fit == VolumeFit::inscribed || shape == VolumeShape::screen) return 1;
  static const auto kScales = [] {
    std::array<std::array<double, 5>, 2> scales{};
    // 1e-6 more than exact: float vertices and the rasteriser's grid must not undercut the light.
    for (int i = 0; i < 2; ++i)
      for (int l = 0; l < 5; ++l)
        scales[i][l] = (1 + 1e-6) / volume_mesh(static_cast<VolumeShape>(i), static_cast<VolumeLevel>(l)).inradius;
    return scales;
  }();
  return kScales[static_cast<int>(shape)][static_cast<int>(level)];
}

glm::dvec3 volume_vertex(const Light& l, const glm::dvec3& vertex, double scale, double slack) {
  if (volume_shape(l) == VolumeShape::cone)
    return volume_f64::cone_vertex(vertex, l.direction, l.range, l.outer_cos, scale, slack);
  return volume_f64::sphere_vertex(vertex, l.range, scale, slack);
}

glm::vec3 volume_vertex_f32(const Light& l, const glm::vec3& vertex, float scale, float slack) {
  const auto range = static_cast<float>(l.range), outer_cos = static_cast<float>(l.outer_cos);
  if (volume_shape(l) == VolumeShape::cone)
    return volume_f32::cone_vertex(vertex, glm::vec3(l.direction), range, outer_cos, scale, slack);
  return volume_f32::sphere_vertex(vertex, range, scale, slack);
}

double volume_reach(const Light& l, double scale, double slack) {
  if (volume_shape(l) == VolumeShape::cone) return volume_f64::cone_reach(l.range, l.outer_cos, scale, slack);
  return volume_f64::sphere_reach(l.range, scale, slack);
}

CullRule cull_rule(LightCull cull, double near_corner) {
  switch (cull) {
    case LightCull::back: return {Faces::front, Faces::front};
    case LightCull::none: return {Faces::both, Faces::both};
    case LightCull::front: return {Faces::back, Faces::back};
    case LightCull::flip: return {Faces::back, Faces::front};
    case LightCull::flip_safe: return {Faces::back, Faces::front, true, near_corner};
  }
  return {Faces::back, Faces::back};
}

Faces faces_to_draw(const CullRule& rule, double camera_distance, double range, double reach) {
  return camera_distance < (rule.by_mesh ? reach : range) + rule.margin ? rule.inside : rule.outside;
}

}  // namespace gbl
