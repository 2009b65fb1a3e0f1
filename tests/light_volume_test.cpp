#include "renderer/light_volume.h"

#include <algorithm>
#include <map>
#include <set>

#include "tests/test_support.h"

namespace gbl {
namespace {

constexpr int kLevels = 5;

struct Face {
  glm::dvec3 a, b, c;
  // Distance of the face's plane from the centre; negative if the face is wound the wrong way round.
  double plane() const { return glm::dot(glm::normalize(glm::cross(b - a, c - a)), a); }
};

std::vector<Face> faces(const VolumeMesh& m) {
  std::vector<Face> out;
  for (size_t t = 0; t < m.triangles.size(); t += 3)
    out.push_back({m.vertices[m.triangles[t]], m.vertices[m.triangles[t + 1]], m.vertices[m.triangles[t + 2]]});
  return out;
}

Settings fitted(VolumeFit fit, int level) {
  Settings s;
  s.lights.volume.fit = fit;
  s.lights.volume.level = static_cast<VolumeLevel>(level);
  return s;
}

TEST(Icosphere, CountsFollowTheLevel) {
  for (int level = 0; level < kLevels; ++level) {
    const VolumeMesh m = icosphere(level);
    const size_t four = size_t{1} << (2 * level);
    EXPECT_EQ(m.triangles.size(), 3 * 20 * four);
    EXPECT_EQ(m.vertices.size(), 10 * four + 2);
    EXPECT_EQ(m.edges.size(), 2 * 30 * four);
  }
}

TEST(Icosphere, IsClosedWithEachEdgeOnce) {
  for (int level = 0; level < kLevels; ++level) {
    const VolumeMesh m = icosphere(level);
    using Edge = std::pair<uint32_t, uint32_t>;
    std::map<Edge, int> directed;
    for (size_t t = 0; t < m.triangles.size(); t += 3)
      for (int k = 0; k < 3; ++k) {
        ASSERT_LT(m.triangles[t + k], m.vertices.size());
        ++directed[{m.triangles[t + k], m.triangles[t + (k + 1) % 3]}];
      }
    std::set<Edge> wire;
    for (size_t i = 0; i < m.edges.size(); i += 2) {
      const Edge edge = std::minmax(m.edges[i], m.edges[i + 1]);
      EXPECT_TRUE(wire.insert(edge).second) << level << ": edge drawn twice";
      EXPECT_EQ(directed.count(edge), 1u) << level << ": no face has this edge";
    }
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1);  // two faces share an edge in opposite directions: closed, and wound alike
      EXPECT_EQ(directed.count({edge.second, edge.first}), 1u);
      EXPECT_EQ(wire.count(std::minmax(edge.first, edge.second)), 1u) << level << ": edge missing from the wire";
    }
  }
}

TEST(Icosphere, VerticesAreOnTheSphereAndFacesLookOutwards) {
  for (int level = 0; level < kLevels; ++level) {
    const VolumeMesh m = icosphere(level);
    for (const glm::vec3& v : m.vertices)
      EXPECT_NEAR(glm::length(glm::dvec3(v)), 1, 1e-7) << level;  // rounded to float once
    for (const Face& f : faces(m)) EXPECT_GT(f.plane(), 0.79) << level;
  }
}

TEST(Icosphere, InradiusIsThatOfTheNearestFace) {
  // Recomputed apart from this code, from the twelve corners in double.
  const double known[kLevels] = {0.794654, 0.934172, 0.982247, 0.995472, 0.998862};
  for (int level = 0; level < kLevels; ++level) {
    const VolumeMesh m = icosphere(level);
    double nearest = 1;
    for (const Face& f : faces(m)) nearest = std::min(nearest, f.plane());
    EXPECT_NEAR(m.inradius, nearest, 1e-12);
    EXPECT_NEAR(m.inradius, known[level], 0.6e-6);
  }
  // Closed form: the icosahedron's inradius over its circumradius.
  EXPECT_NEAR(icosphere(0).inradius, std::sqrt((5 + 2 * std::sqrt(5.0)) / 15), 1e-7);
}

TEST(VolumeScale, CircumscribedMeshContainsItsSphere) {
  for (int level = 0; level < kLevels; ++level) {
    const double scale = volume_scale(fitted(VolumeFit::circumscribed, level));
    const VolumeMesh m = icosphere(level);
    EXPECT_NEAR(scale, 1 / m.inradius, 2e-6);  // no larger than it must be
    for (const Face& f : faces(m)) EXPECT_GE(f.plane() * scale, 1);
    // As the vertex shader does it: float vertices times a float scale.
    VolumeMesh scaled = m;
    for (glm::vec3& v : scaled.vertices) v *= static_cast<float>(scale);
    for (const Face& f : faces(scaled)) EXPECT_GE(f.plane(), 1);
  }
}

TEST(VolumeScale, InscribedMeshCutsIntoItsSphere) {
  for (int level = 0; level < kLevels; ++level) {
    EXPECT_EQ(volume_scale(fitted(VolumeFit::inscribed, level)), 1);
    for (const Face& f : faces(icosphere(level))) EXPECT_LT(f.plane(), 1);
  }
}

TEST(FacesToDraw, TruthTableWithItsBoundaries) {
  constexpr double kRange = 10, kScale = 1.25, kCorner = 1.5;  // flip-safe turns at 10 * 1.25 + 1.5 = 14
  struct Row {
    LightCull cull;
    double distance;
    Faces faces;
  };
  const double just_below_10 = std::nextafter(10.0, 0.0), just_below_14 = std::nextafter(14.0, 0.0);
  const Row kTable[] = {
      {LightCull::back, 0, Faces::front},       {LightCull::back, 100, Faces::front},
      {LightCull::none, 0, Faces::both},        {LightCull::none, 100, Faces::both},
      {LightCull::front, 0, Faces::back},       {LightCull::front, 100, Faces::back},
      {LightCull::flip, 0, Faces::back},        {LightCull::flip, just_below_10, Faces::back},
      {LightCull::flip, 10, Faces::front},  // source 0 asks distance < radius
      {LightCull::flip, 100, Faces::front},     {LightCull::flip_safe, 0, Faces::back},
      {LightCull::flip_safe, 10, Faces::back},  {LightCull::flip_safe, just_below_14, Faces::back},
      {LightCull::flip_safe, 14, Faces::front}, {LightCull::flip_safe, 100, Faces::front},
  };
  for (const Row& r : kTable)
    EXPECT_EQ(faces_to_draw(r.cull, r.distance, kRange, kScale, kCorner), r.faces)
        << row(r.cull).id << " at " << r.distance;
  for (const ValueRow& r : rows<LightCull>()) {
    const bool in_table = std::any_of(std::begin(kTable), std::end(kTable),
                                      [&](const Row& t) { return static_cast<int>(t.cull) == r.value; });
    EXPECT_TRUE(in_table) << r.id;
  }
}

// A sound rule never leaves a light without faces: whenever the near plane may cut the mesh, back faces are drawn.
TEST(FacesToDraw, SoundRulesNeverDrawCutFrontFaces) {
  for (const double distance : {0.0, 5.0, 9.99, 10.0, 11.0, 12.5, 13.0, 13.99, 14.0, 14.01, 50.0})
    for (const ValueRow& r : rows<LightCull>()) {
      if (!r.sound()) continue;
      const Faces drawn = faces_to_draw(static_cast<LightCull>(r.value), distance, 10, 1.25, 1.5);
      EXPECT_TRUE(distance >= 10 * 1.25 + 1.5 || drawn == Faces::back) << r.id << " at " << distance;
    }
}

}  // namespace
}  // namespace gbl
