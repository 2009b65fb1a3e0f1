#include "renderer/light/light_volume.h"

#include <algorithm>
#include <map>
#include <set>

#include "renderer/base/random.h"
#include "renderer/frame/attachments.h"
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

TEST(VolumeMeshes, AreClosedWithEachEdgeOnce) {
  for (const VolumeShape shape : {VolumeShape::sphere, VolumeShape::cone})
    for (int level = 0; level < kLevels; ++level) {
      const VolumeMesh m = volume_mesh(shape, static_cast<VolumeLevel>(level));
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
    const double scale = volume_scale(VolumeFit::circumscribed, static_cast<VolumeLevel>(level), VolumeShape::sphere);
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
    EXPECT_EQ(volume_scale(VolumeFit::inscribed, static_cast<VolumeLevel>(level), VolumeShape::sphere), 1);
    for (const Face& f : faces(icosphere(level))) EXPECT_LT(f.plane(), 1);
  }
}

// ---- cones -------------------------------------------------------------------------------------------------
Light spot(double outer_deg, double range = 10, const glm::dvec3& direction = {0, 0, 1}) {
  Light l;
  l.kind = LightKind::spot;
  l.range = range;
  l.direction = glm::normalize(direction);
  l.outer_cos = std::cos(glm::radians(outer_deg));
  return l;
}

glm::dvec3 random_direction(Pcg32& random) {
  const double z = random.in(-1, 1), turn = random.in(-3.14159265358979, 3.14159265358979), r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

// A direction at most `outer` from the axis; one in four on the very edge.
glm::dvec3 within_the_cone(const Light& l, Pcg32& random) {
  const double outer = std::acos(l.outer_cos), angle = random.next() % 4 ? outer * random.in(0, 1) : outer;
  const glm::dvec3 side = glm::normalize(glm::cross(l.direction, random_direction(random)));
  return std::cos(angle) * l.direction + std::sin(angle) * side;
}

// The light's mesh as the vertex shader places it, light at the origin: in double, or in its float.
VolumeMesh placed(const Light& l, const Settings& s, double slack, bool as_float) {
  VolumeMesh m = volume_mesh(volume_shape(l), s.lights.volume.level);
  const double scale = volume_scale(s.lights.volume.fit, s.lights.volume.level, volume_shape(l));
  for (glm::vec3& v : m.vertices)
    v = as_float ? volume_vertex_f32(l, v, static_cast<float>(scale), static_cast<float>(slack))
                 : glm::vec3(volume_vertex(l, v, scale, slack));
  return m;
}

// How far out of a convex mesh a point is: negative inside.
double outside_by(const VolumeMesh& m, const glm::dvec3& point) {
  double most = -1e30;
  for (const Face& f : faces(m))
    most = std::max(most, glm::dot(glm::normalize(glm::cross(f.b - f.a, f.c - f.a)), point - f.a));
  return most;
}

TEST(VolumeShapes, NarrowSpotsAreConesAndEndlessLightsHaveNone) {
  EXPECT_EQ(volume_shape(Light{.range = 5}), VolumeShape::sphere);
  EXPECT_EQ(volume_shape(spot(1)), VolumeShape::cone);
  EXPECT_EQ(volume_shape(spot(59.99)), VolumeShape::cone);
  EXPECT_EQ(volume_shape(spot(60.01)), VolumeShape::sphere);
  EXPECT_EQ(volume_shape(spot(90)), VolumeShape::sphere);
  EXPECT_EQ(volume_shape(spot(30, kEndless)), VolumeShape::screen);
  EXPECT_EQ(volume_shape(Light{}), VolumeShape::screen);
  Light sun = spot(30);
  sun.kind = LightKind::directional;
  EXPECT_EQ(volume_shape(sun), VolumeShape::screen);
}

TEST(Cone, FacesLookOutwardsAndItsBaseIsRound) {
  for (int level = 0; level < kLevels; ++level) {
    const VolumeMesh m = volume_mesh(VolumeShape::cone, static_cast<VolumeLevel>(level));
    const glm::dvec3 inside(0, 0, 0.75);
    for (const Face& f : faces(m))
      EXPECT_LT(glm::dot(glm::cross(f.b - f.a, f.c - f.a), inside - f.a), 0) << level << ": wound the wrong way";
    const size_t sides = m.vertices.size() - 2;
    EXPECT_EQ(m.triangles.size(), 3 * 2 * sides);
    EXPECT_NEAR(m.inradius, std::cos(3.14159265358979 / double(sides)), 1e-12);
  }
}

// Any angle, range and direction: every point that the light reaches is inside, in the shader's float too.
TEST(Cone, CircumscribedMeshContainsTheSector) {
  Pcg32 random(5);
  for (int k = 0; k < 2000; ++k) {
    const Settings s = fitted(VolumeFit::circumscribed, k % kLevels);
    const double outer = k % 10 == 0 ? std::pow(10, random.in(-2, 0)) : random.in(0.5, 59.9);
    const Light l = spot(outer, std::pow(10, random.in(-1, 4)), random_direction(random));
    const double slack = k % 2 ? l.range * random.in(0, 0.1) : 0;
    // One float more or less of a vertex, and normals of faces that are as thin as the cone.
    const double rounding = 1e-6 * l.range / std::min(1.0, outer);
    for (const bool as_float : {false, true}) {
      const VolumeMesh m = placed(l, s, slack, as_float);
      for (int i = 0; i < 20; ++i) {
        const glm::dvec3 reached = within_the_cone(l, random) * (i < 10 ? l.range : l.range * random.in(0, 1));
        const glm::dvec3 near_it = reached + slack * random_direction(random);
        EXPECT_LE(outside_by(m, near_it), as_float ? rounding : 1e-9 * l.range)
            << outer << " degrees, range " << l.range << ", slack " << slack << (as_float ? ", float" : "");
      }
    }
  }
}

TEST(Cone, IsNoLargerThanItMustBe) {
  Pcg32 random(6);
  for (int k = 0; k < 200; ++k) {
    const Light l = spot(random.in(0.5, 59.9), 10, random_direction(random));
    const VolumeMesh m = placed(l, fitted(VolumeFit::circumscribed, 4), 0, false);
    const double base = 10 * std::tan(std::acos(l.outer_cos)) / std::cos(3.14159265358979 / 36);
    for (const glm::vec3& v : m.vertices) {
      const double along = glm::dot(glm::dvec3(v), l.direction);
      EXPECT_LE(along, 10 * 1.00001);
      EXPECT_LE(glm::length(glm::dvec3(v) - along * l.direction), base * 1.00001);
    }
  }
}

TEST(Cone, InscribedMeshCutsIntoTheCone) {
  const Light l = spot(40);
  const VolumeMesh m = placed(l, fitted(VolumeFit::inscribed, 0), 0, false);
  const double outer = std::acos(l.outer_cos);
  double most = 0;
  for (int k = 0; k < 16; ++k) {  // corners and middles of the eight sides
    const double turn = 3.14159265358979 / 8 * k;
    const glm::dvec3 on_rim(std::sin(outer) * std::cos(turn), std::sin(outer) * std::sin(turn), std::cos(outer));
    most = std::max(most, outside_by(m, 9.9 * on_rim));
  }
  EXPECT_GT(most, 0.1);
}

TEST(VolumeReach, IsThatOfTheFarthestVertex) {
  Pcg32 random(8);
  for (int k = 0; k < 100; ++k) {
    const Settings s = fitted(k % 2 ? VolumeFit::circumscribed : VolumeFit::inscribed, k % kLevels);
    const Light l = k % 3 ? spot(random.in(1, 59.9), random.in(1, 100), random_direction(random)) : Light{.range = 7};
    const double slack = random.in(0, 1),
                 scale = volume_scale(s.lights.volume.fit, s.lights.volume.level, volume_shape(l));
    double farthest = 0;
    for (const glm::vec3& v : placed(l, s, slack, false).vertices)
      farthest = std::max(farthest, glm::length(glm::dvec3(v)));
    EXPECT_NEAR(volume_reach(l, scale, slack), farthest, 1e-5 * farthest);
  }
}

// ---- depth -------------------------------------------------------------------------------------------------
TEST(VolumeDepthStep, IsTheFormatsAndNothingWithoutADepthTest) {
  Settings s;
  EXPECT_EQ(volume_depth_step(s), 0);
  s.lights.volume.depth = VolumeDepth::greater_equal;
  for (const auto& [format, bits] :
       {std::pair(DepthFormat::d16, 16), {DepthFormat::d24, 24}, {DepthFormat::d32f, 24}}) {
    s.depth.format = format;
    EXPECT_GE(volume_depth_step(s), std::ldexp(1, -bits));
    EXPECT_LE(volume_depth_step(s), std::ldexp(1, -bits) + 1e-6);
  }
  s.lights.method = LightMethod::fullscreen;
  EXPECT_EQ(volume_depth_step(s), 0);
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
    EXPECT_EQ(faces_to_draw(cull_rule(r.cull, kCorner), r.distance, kRange, kRange * kScale), r.faces)
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
      const Faces drawn = faces_to_draw(cull_rule(static_cast<LightCull>(r.value), 1.5), distance, 10, 12.5);
      EXPECT_TRUE(distance >= 10 * 1.25 + 1.5 || drawn == Faces::back) << r.id << " at " << distance;
    }
}

}  // namespace
}  // namespace gbl
