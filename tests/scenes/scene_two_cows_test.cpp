// The numbers of source 0's figures of light volumes, checked on the meshes.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

#include "renderer/scenes/builtin_scenes.h"

namespace gbl {
namespace {

const Scene& scene() {
  static const Scene built = build_two_cows();
  return built;
}

const Instance& instance(const std::string& name) {
  for (const Instance& i : scene().instances)
    if (i.name == name) return i;
  throw std::out_of_range("no instance " + name);
}

std::vector<glm::dvec3> corners_of(const std::string& name) {
  const Instance& i = instance(name);
  std::vector<glm::dvec3> out;
  for (const Vertex& v : scene().meshes[i.mesh].vertices)
    out.emplace_back(i.world_from_object * glm::dvec4(glm::dvec3(v.position), 1));
  return out;
}

Bounds box_of(const std::vector<glm::dvec3>& points) {
  Bounds b{glm::dvec3(1e9), glm::dvec3(-1e9)};
  for (const glm::dvec3& p : points) b.min = glm::min(b.min, p), b.max = glm::max(b.max, p);
  return b;
}

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "axis " << k;
}

// Nearest point of a triangle (Ericson 2005, "Real-Time Collision Detection", 5.1.5): inside, else on an edge.
double distance_to_triangle(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
  const auto inside = [&](glm::dvec3 from, glm::dvec3 to) { return glm::dot(glm::cross(to - from, p - from), n) >= 0; };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(glm::dot(p - a, n));
  const auto to_edge = [p](glm::dvec3 from, glm::dvec3 to) {
    const double t = glm::clamp(glm::dot(p - from, to - from) / glm::dot(to - from, to - from), 0.0, 1.0);
    return glm::distance(p, from + (to - from) * t);
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

double distance_to(const std::string& name, glm::dvec3 p) {
  const std::vector<glm::dvec3> corners = corners_of(name);
  const std::vector<uint32_t>& indices = scene().meshes[instance(name).mesh].indices;
  double nearest = 1e9;
  for (size_t i = 0; i < indices.size(); i += 3)
    nearest = std::min(nearest,
                       distance_to_triangle(p, corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]));
  return nearest;
}

// Height of the ground below a point, from the triangle that is drawn there.
double ground_below(glm::dvec3 p) {
  static const std::vector<glm::dvec3> corners = corners_of("ground");
  const std::vector<uint32_t>& indices = scene().meshes[instance("ground").mesh].indices;
  for (size_t i = 0; i < indices.size(); i += 3) {
    const glm::dvec3 a = corners[indices[i]], b = corners[indices[i + 1]], c = corners[indices[i + 2]];
    const auto side = [p](glm::dvec3 from, glm::dvec3 to) {
      return (to.z - from.z) * (p.x - from.x) - (to.x - from.x) * (p.z - from.z);
    };
    if (side(a, b) < 0 || side(b, c) < 0 || side(c, a) < 0) continue;
    const glm::dvec3 n = glm::cross(b - a, c - a);
    return a.y - ((p.x - a.x) * n.x + (p.z - a.z) * n.z) / n.y;
  }
  return -1e9;
}

TEST(TwoCows, StandInTheirBoxes) {
  const Bounds near = box_of(corners_of("near cow")), far = box_of(corners_of("far cow"));
  expect_near(near.min, {-1.55, 0, -8.2}, 1e-9);
  expect_near(near.max, {-0.45, 0.8, -7.8}, 1e-9);
  expect_near(far.min, {1.35, -3.2, -24.6}, 1e-9);
  expect_near(far.max, {4.65, -0.8, -23.4}, 1e-9);
  EXPECT_EQ(instance("near cow").mesh, instance("far cow").mesh);
}

TEST(TwoCows, AreAsLargeOnTheScreen) {
  const Camera& camera = scene().camera;
  EXPECT_EQ(camera.position, glm::dvec3(0, 1.6, 0));
  EXPECT_EQ(camera.fov, 45);
  const std::vector<glm::dvec3> near = corners_of("near cow"), far = corners_of("far cow");
  const glm::dmat4 clip = clip_from_relative(camera, 16.0 / 9);
  for (size_t i = 0; i < near.size(); ++i) {
    const glm::dvec4 a = clip * glm::dvec4(near[i] - camera.position, 1);
    const glm::dvec4 b = clip * glm::dvec4(far[i] - camera.position, 1);
    ASSERT_NEAR(a.x / a.w, -b.x / b.w, 1e-9);
    ASSERT_NEAR(a.y / a.w, b.y / b.w, 1e-9);
  }
}

TEST(TwoCows, NearOneIsInTheLightAndFarOneOnlyWithinItsSilhouette) {
  const Light& light = scene().lights[0];
  EXPECT_EQ(light.position, glm::dvec3(0, 0.9, -8));
  EXPECT_EQ(light.range, 2.4);
  const glm::dvec3 eye = scene().camera.position, axis = light.position - eye;
  EXPECT_NEAR(glm::degrees(std::asin(light.range / glm::length(axis))), 17.4, 0.05);
  for (const glm::dvec3& p : corners_of("near cow")) EXPECT_LT(glm::distance(p, light.position), 1.805);
  double nearest = 1e9, widest = 0;
  for (const glm::dvec3& p : corners_of("far cow")) {
    nearest = std::min(nearest, glm::distance(p, light.position));
    widest = std::max(widest, std::acos(glm::dot(glm::normalize(p - eye), glm::normalize(axis))));
  }
  EXPECT_GT(nearest, 15.5);
  EXPECT_LT(glm::degrees(widest), 12.85);
}

TEST(TwoCows, StandOnGroundThatHidesNothingOfThem) {
  const glm::dvec3 eye = scene().camera.position;
  for (const char* name : {"near cow", "far cow"}) {
    const std::vector<glm::dvec3> corners = corners_of(name);
    const Bounds box = box_of(corners);
    double gap = -1e9;
    for (size_t i = 0; i < corners.size(); i += 7) {
      if (corners[i].y < box.min.y + 0.02 * box.extent().y)
        gap = std::max(gap, corners[i].y - ground_below(corners[i]));
      for (double t = 0.3; t < 0.97; t += 0.06) {
        const glm::dvec3 p = eye + (corners[i] - eye) * t;
        ASSERT_GT(p.y, ground_below(p)) << name << " at " << t;
      }
    }
    EXPECT_LT(std::abs(gap), 0.06) << name;
  }
}

TEST(TwoCows, LightAHoldsNothingAndLightBPartOfTheTree) {
  ASSERT_EQ(scene().lights.size(), 3u);
  const Light &a = scene().lights[1], &b = scene().lights[2];
  EXPECT_EQ(a.position, glm::dvec3(-3, 3.2, -9));
  EXPECT_EQ(a.range, 1.2);
  EXPECT_EQ(b.position, glm::dvec3(2.2, 1.8, -9));
  EXPECT_EQ(b.range, 1.5);
  for (const Instance& i : scene().instances) {
    EXPECT_GT(distance_to(i.name, a.position), a.range) << i.name;
    if (i.name.rfind("tree ", 0) != 0) {
      EXPECT_GT(distance_to(i.name, b.position), b.range) << i.name;
    }
  }
  for (const char* part : {"tree trunk", "tree crown"}) {
    const std::vector<glm::dvec3> corners = corners_of(part);
    const auto within = std::count_if(corners.begin(), corners.end(),
                                      [&b](glm::dvec3 p) { return glm::distance(p, b.position) < b.range; });
    EXPECT_GT(within, 20) << part;
    EXPECT_LT(static_cast<size_t>(within), corners.size() * 9 / 10) << part;
  }
}

}  // namespace
}  // namespace gbl
