#include "renderer/scene/camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

constexpr double kWide = 16.0 / 9;

Camera some_camera(Pcg32& random, bool orthographic) {
  Camera c;
  c.position = {random.in(-5000, 5000), random.in(-5000, 5000), random.in(-5000, 5000)};
  c.orientation = orientation_from_yaw_pitch(random.in(-180, 180), random.in(-89, 89));
  c.fov = random.in(20, 110);
  c.orthographic_height = orthographic ? random.in(1, 2000) : 0;
  c.near = random.in(0.1, 10);
  c.far = c.near * random.in(10, 10000);
  return c;
}

// From the formula in camera.h.
glm::dvec3 relative_point(const Camera& c, const ViewRays& rays, double x, double y, double range) {
  const glm::dvec3 sideways = x * rays.right + y * rays.up;
  return c.orthographic() ? range * rays.forward + sideways : range * (rays.forward + sideways);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " for " << b.x << " " << b.y << " " << b.z;
}

TEST(Camera, IdentityLooksAlongMinusZ) {
  const Camera c;
  EXPECT_EQ(c.forward(), glm::dvec3(0, 0, -1));
  EXPECT_EQ(c.right(), glm::dvec3(1, 0, 0));
  EXPECT_EQ(c.up(), glm::dvec3(0, 1, 0));
}

TEST(Camera, YawTurnsLeftAndPitchLooksUp) {
  const double k = 1e-15;  // a few roundings of unit vectors
  const double h = std::sqrt(0.5);
  Camera c;
  c.orientation = orientation_from_yaw_pitch(90, 0);
  expect_near(c.forward(), {-1, 0, 0}, k);
  expect_near(c.right(), {0, 0, -1}, k);
  c.orientation = orientation_from_yaw_pitch(0, 45);
  expect_near(c.forward(), {0, h, -h}, k);
  expect_near(c.right(), {1, 0, 0}, k);
  c.orientation = orientation_from_yaw_pitch(90, 45);  // pitch about the turned right axis: no roll
  expect_near(c.forward(), {-h, h, 0}, k);
  EXPECT_NEAR(c.right().y, 0, k);
  c.orientation = orientation_from_yaw_pitch(7, -23);
  EXPECT_LT(c.forward().y, 0);
  EXPECT_LT(c.forward().x, 0);
}

TEST(Camera, YawAndPitchReadBack) {
  for (int yaw = -175; yaw <= 180; yaw += 5)
    for (int pitch = -90; pitch <= 90; pitch += 5) {
      const glm::dvec2 back = yaw_pitch_of(orientation_from_yaw_pitch(yaw, pitch));
      // asin near +-90 degrees loses half the digits: 1e-8 radians.
      EXPECT_NEAR(back.y, pitch, std::abs(pitch) == 90 ? 2e-6 : 1e-10) << yaw << " " << pitch;
      EXPECT_NEAR(std::remainder(back.x - yaw, 360), 0, 1e-10) << yaw << " " << pitch;
    }
}

TEST(Camera, RaysAndDepthRebuildTheProjectedPoint) {
  Pcg32 random(1);
  for (const bool orthographic : {false, true})
    for (int i = 0; i < 2000; ++i) {
      const Camera c = some_camera(random, orthographic);
      const double aspect = random.in(0.5, 3);
      const ViewRays rays = view_rays(c, aspect);
      const double range = std::exp(random.in(std::log(c.near), std::log(c.far)));
      const double x = random.in(-1, 1), y = random.in(-1, 1);
      const glm::dvec3 point = relative_point(c, rays, x, y, range);
      EXPECT_NEAR(glm::dot(point, c.forward()), range, 1e-9 * range);

      const glm::dvec4 clip = clip_from_relative(c, aspect) * glm::dvec4(point, 1);
      const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
      EXPECT_NEAR(ndc.x, x, 1e-9);
      EXPECT_NEAR(ndc.y, y, 1e-9);
      const double depth = ndc.z * 0.5 + 0.5;
      EXPECT_GE(depth, -1e-12);
      EXPECT_LE(depth, 1 + 1e-12);

      // Through the projection and back. A depth near 1 holds 2^-53; far/near = 1e4 makes 1e-12 of it.
      const glm::dvec3 again = relative_point(c, rays, ndc.x, ndc.y, range_from_depth(c, depth));
      expect_near(again, point, 1e-9 * glm::length(point));
      const glm::dvec4 inverted = glm::inverse(clip_from_relative(c, aspect)) * glm::dvec4(ndc, 1);
      expect_near(glm::dvec3(inverted) / inverted.w, point, 1e-8 * glm::length(point));  // the matrix loses a digit
      if (HasFailure()) FAIL() << "camera " << i;
    }
}

TEST(Camera, DepthAndRangeAreInverseAndMeetThePlanes) {
  Pcg32 random(2);
  for (const bool orthographic : {false, true})
    for (int i = 0; i < 200; ++i) {
      const Camera c = some_camera(random, orthographic);
      EXPECT_NEAR(range_from_depth(c, 0), c.near, 1e-12 * c.near);
      EXPECT_NEAR(range_from_depth(c, 1), c.far, 1e-11 * c.far);
      EXPECT_NEAR(depth_from_range(c, c.near), 0, 1e-12);
      EXPECT_NEAR(depth_from_range(c, c.far), 1, 1e-12);
      const double depth = random.unit();
      EXPECT_NEAR(depth_from_range(c, range_from_depth(c, depth)), depth, 1e-12);
    }
  Camera c;  // near 1, far 10000: half of the depth codes lie within two units
  EXPECT_NEAR(depth_from_range(c, 2), 0.5, 1e-4);
}

// Reed 2015: 1 at the near plane, 0 at the far one, x and y as ever.
TEST(Camera, ReversedDepthRunsTheOtherWay) {
  Pcg32 random(5);
  for (const bool orthographic : {false, true})
    for (int i = 0; i < 200; ++i) {
      const Camera c = some_camera(random, orthographic);
      const ViewRays rays = view_rays(c, kWide);
      const double x = random.in(-1, 1), y = random.in(-1, 1), range = random.in(c.near, c.far);
      const auto ndc_at = [&](double distance) {
        const glm::dvec3 point = relative_point(c, rays, x, y, distance);
        const glm::dvec4 clip = clip_from_relative(c, kWide, DepthRuns::reversed) * glm::dvec4(point, 1);
        return glm::dvec3(clip) / clip.w;
      };
      EXPECT_NEAR(ndc_at(c.near).z, 1, 1e-9);
      EXPECT_NEAR(ndc_at(c.far).z, 0, 1e-9);
      EXPECT_NEAR(ndc_at(range).x, x, 1e-9);
      EXPECT_NEAR(ndc_at(range).y, y, 1e-9);
      EXPECT_NEAR(ndc_at(range).z, depth_from_range(c, range, DepthRuns::reversed), 1e-9);
      EXPECT_NEAR(depth_from_range(c, range, DepthRuns::reversed), 1 - depth_from_range(c, range), 1e-12);
      EXPECT_NEAR(range_from_depth(c, depth_from_range(c, range, DepthRuns::reversed), DepthRuns::reversed), range,
                  1e-9 * range);
    }
}

TEST(Camera, RangeIsExactForAnyRatioOfThePlanes) {
  Camera c;
  c.near = 1e-6;
  c.far = 1e9;
  // 1 - depth is exact from 0.5 on, so the last double below 1 still tells near / (1 - depth).
  const double last = 1 - 0x1p-53;
  EXPECT_NEAR(range_from_depth(c, last), 1e-6 / (0x1p-53 + 1e-15), 1e-2 * 1e9);
  EXPECT_NEAR(range_from_depth(c, 1), 1e9, 1e-6);
}

TEST(Camera, NearCornerFactorsAreTheClosedForms) {
  Camera c;
  const auto factor = [&](double fov) {
    c.fov = fov;
    return near_corner_factor(c, kWide);
  };
  EXPECT_NEAR(factor(45), 1.309, 0.5e-3);
  EXPECT_NEAR(factor(60), 1.545, 0.5e-3);
  EXPECT_NEAR(factor(90), 2.272, 0.5e-3);
  EXPECT_NEAR(factor(90), std::sqrt(2 + kWide * kWide), 1e-15);  // tan 45 = 1
  Pcg32 random(3);
  for (const bool orthographic : {false, true})
    for (int i = 0; i < 100; ++i) {
      const Camera some = some_camera(random, orthographic);
      const ViewRays rays = view_rays(some, kWide);
      const glm::dvec3 corner = relative_point(some, rays, 1, -1, some.near);
      EXPECT_NEAR(near_corner_factor(some, kWide) * some.near, glm::length(corner), 1e-12 * glm::length(corner));
    }
}

// ---- the same in float, as shaders/position.glsl does it ---------------------------------------------------

struct FloatError {
  double by_ray, by_matrix;  // largest distance to the true point, world units
};

// Terrain camera, points at one range. The float depth is taken as true: the error is the arithmetic's alone.
FloatError float_error(double range) {
  Camera c;
  c.position = {2056, 500, 4112};
  const ViewRays rays = view_rays(c, kWide);
  const glm::vec3 forward(rays.forward), right(rays.right), up(rays.up);
  const auto near = static_cast<float>(c.near), depth_span = static_cast<float>(c.far - c.near);
  const auto product = static_cast<float>(c.near * c.far);
  const glm::mat4 clip_from_world =
      glm::mat4(clip_from_view(c, kWide)) * glm::translate(glm::mat4(1), -glm::vec3(c.position));
  const glm::mat4 world_from_clip = glm::inverse(clip_from_world);
  FloatError worst{0, 0};
  Pcg32 random(4);
  for (int i = 0; i < 20000; ++i) {
    const auto x = static_cast<float>(random.in(-1, 1)), y = static_cast<float>(random.in(-1, 1));
    const auto depth = static_cast<float>(depth_from_range(c, range * random.in(0.99, 1.01)));
    const glm::dvec3 truth = relative_point(c, rays, x, y, range_from_depth(c, depth));
    const float by_depth = product / (near + (1 - depth) * depth_span);
    const glm::vec3 ray = by_depth * (forward + x * right + y * up);
    const glm::vec4 world = world_from_clip * glm::vec4(x, y, depth * 2 - 1, 1);
    const glm::vec3 by_matrix = glm::vec3(world) / world.w - glm::vec3(c.position);
    worst.by_ray = std::max(worst.by_ray, glm::length(glm::dvec3(ray) - truth));
    worst.by_matrix = std::max(worst.by_matrix, glm::length(glm::dvec3(by_matrix) - truth));
  }
  return worst;
}

TEST(Camera, FloatMatrixIsFarWorseThanFloatRay) {
  // Measured:  range   by ray   by matrix (units)
  //              100  0.00001       0.03
  //             1000  0.00013       0.39
  //             4000  0.00055       1.5
  //             9000  0.00126       3.8
  for (const double range : {100.0, 1000.0, 4000.0, 9000.0}) {
    const FloatError e = float_error(range);
    // Five float operations of half a unit in the last place, at points up to 1.3 ranges away.
    EXPECT_LE(e.by_ray, 5 * 0x1p-24 * 1.3 * range) << range;
    EXPECT_GE(e.by_matrix, 500 * e.by_ray) << range;
  }
  EXPECT_NEAR(float_error(9000).by_matrix, 3.8, 0.5);  // the number that the option's help speaks of
}

}  // namespace
}  // namespace gbl
