// Culling by boxes leaves out nothing that can be seen, and something that cannot.
#include "renderer/scene/view_culling.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/scene/mesh_parts.h"
#include "renderer/scenes/builtin_scenes.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

glm::dvec3 within(Pcg32& random, const Bounds& box) {
  return {random.in(box.min.x, box.max.x), random.in(box.min.y, box.max.y), random.in(box.min.z, box.max.z)};
}

Bounds random_box(Pcg32& random) {
  const glm::dvec3 centre(random.in(-60, 60), random.in(-60, 60), random.in(-60, 60));
  const glm::dvec3 half(random.in(0, 9), random.in(0, 9), random.in(0, 9));
  return {centre - half, centre + half};
}

Camera random_camera(Pcg32& random, bool orthographic) {
  Camera c;
  c.orientation = glm::normalize(glm::dquat(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)));
  c.near = random.in(0.01, 2), c.far = random.in(20, 90), c.fov = random.in(10, 120);
  c.orthographic_height = orthographic ? random.in(5, 60) : 0;
  return c;
}

bool inside(const glm::dvec4& p, DepthRuns runs) {
  const double nearest = runs == DepthRuns::reversed ? 0 : -p.w;
  return std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && p.z >= nearest && p.z <= p.w;
}

TEST(ViewCulling, NoBoxIsLeftOutThatHoldsAPointInView) {
  Pcg32 random(3);
  int left_out = 0, seen = 0;
  for (int k = 0; k < 4000; ++k) {
    const DepthRuns runs = k % 2 ? DepthRuns::reversed : DepthRuns::standard;
    const glm::dmat4 clip = clip_from_relative(random_camera(random, k % 3 == 0), 1.5, runs);
    const Bounds box = random_box(random);
    const bool may = may_be_seen(box, clip, runs);
    left_out += !may;
    for (int i = 0; i < 50; ++i)
      if (inside(clip * glm::dvec4(within(random, box), 1), runs)) {
        ++seen;
        ASSERT_TRUE(may) << "box " << k;
      }
  }
  EXPECT_GT(left_out, 2000) << "most boxes of the space about a camera are beside what it sees";
  EXPECT_GT(seen, 1000);
}

TEST(ViewCulling, BoxesBehindTheCameraAreLeftOut) {
  Camera c;
  c.near = 0.1, c.far = 100;
  for (const DepthRuns runs : {DepthRuns::standard, DepthRuns::reversed}) {
    const glm::dmat4 clip = clip_from_relative(c, 1, runs);
    EXPECT_TRUE(may_be_seen({{-1, -1, -6}, {1, 1, -5}}, clip, runs));
    EXPECT_FALSE(may_be_seen({{-1, -1, 5}, {1, 1, 6}}, clip, runs));
    EXPECT_FALSE(may_be_seen({{-1, -1, -300}, {1, 1, -200}}, clip, runs)) << "beyond the far plane";
    EXPECT_TRUE(may_be_seen({{-200, -200, -200}, {200, 200, 200}}, clip, runs)) << "the camera is in it";
  }
}

using Triangle = std::array<uint32_t, 3>;
std::vector<Triangle> sorted_triangles(const std::vector<uint32_t>& indices) {
  std::vector<Triangle> out;
  for (size_t i = 0; i + 2 < indices.size(); i += 3) out.push_back({indices[i], indices[i + 1], indices[i + 2]});
  std::sort(out.begin(), out.end());
  return out;
}

TEST(MeshParts, HoldEachTriangleOnceWithinItsBox) {
  const Scene terrain = build_terrain();
  size_t cut = 0;
  for (const Mesh& mesh : terrain.meshes) {
    const MeshInParts m = in_parts(mesh);
    std::vector<uint32_t> indices = m.indices;
    for (uint32_t& i : indices) i = m.vertices.at(i);
    EXPECT_EQ(sorted_triangles(indices), sorted_triangles(mesh.indices));
    uint32_t next = 0;
    double volume = 0;
    for (const MeshPart& p : m.parts) {
      EXPECT_EQ(p.first, next);
      next += p.count;
      for (uint32_t i = p.first; i < next; ++i) {
        const glm::dvec3 v(mesh.vertices[indices[i]].position);
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(v, p.box.min)) && glm::all(glm::lessThanEqual(v, p.box.max)));
      }
      volume += p.box.extent().x * p.box.extent().z;
    }
    EXPECT_EQ(next, mesh.indices.size());
    if (m.parts.size() == 1) continue;
    ++cut;
    const glm::dvec3 all = bounds_of(mesh).extent();
    EXPECT_LT(volume, 3 * all.x * all.z) << "parts lie together: their boxes hardly overlap on the ground";
  }
  EXPECT_GE(cut, 1u);
}

}  // namespace
}  // namespace gbl::test
