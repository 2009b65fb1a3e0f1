#include "renderer/light_volume.h"

#include <algorithm>
#include <array>
#include <map>

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

double volume_scale(const Settings& s) {
  if (s.lights.volume.fit == VolumeFit::inscribed) return 1;
  static const auto kScales = [] {
    std::array<double, 5> scales{};
    // 1e-6 more than exact: float vertices and the rasteriser's grid must not undercut the sphere.
    for (int level = 0; level < 5; ++level) scales[level] = (1 + 1e-6) / icosphere(level).inradius;
    return scales;
  }();
  return kScales[static_cast<int>(s.lights.volume.level)];
}

Faces faces_to_draw(LightCull cull, double camera_distance, double range, double scale, double near_corner) {
  switch (cull) {
    case LightCull::back: return Faces::front;
    case LightCull::none: return Faces::both;
    case LightCull::front: return Faces::back;
    case LightCull::flip: return camera_distance < range ? Faces::back : Faces::front;
    case LightCull::flip_safe: return camera_distance < range * scale + near_corner ? Faces::back : Faces::front;
  }
  return Faces::back;
}

}  // namespace gbl
