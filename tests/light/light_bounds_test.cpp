// Screen bounds hold every point that a light reaches, and no more than its sphere's own outline.
#include "renderer/light/light_bounds.h"

#include <algorithm>
#include <fmt/format.h>

#include "tests/random_view.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

// Places with names: the bounds' cases are where the sphere lies to eye and near plane.
Ball ball_of(Pcg32& random, const Camera& c) {
  const double radius = random.in(0.1, 12);
  const double ahead = random.in(-1.5, 3) * radius, aside = random.in(0, 3) * radius;
  return {c.position + c.forward() * (c.near + ahead) + random_direction(random) * aside, radius};
}

struct Projected {
  glm::dvec2 ndc;
  double depth;
};
Projected project(const Camera& c, double aspect, const glm::dvec3& world) {
  const glm::dvec4 clip = clip_from_relative(c, aspect) * glm::dvec4(world - c.position, 1);
  return {glm::dvec2(clip) / clip.w, view_of(c, world).z};
}

bool inside(const ScreenBounds& b, glm::dvec2 p) {
  return p.x >= b.from.x && p.x <= b.to.x && p.y >= b.from.y && p.y <= b.to.y;
}

std::string text(const ScreenBounds& b) {
  return fmt::format("{:.9g} … {:.9g}, {:.9g} … {:.9g}", b.from.x, b.to.x, b.from.y, b.to.y);
}

TEST(ScreenBoundsOf, ABallHoldEveryPointBeyondTheNearPlane) {
  Pcg32 random(3);
  int seen = 0, crossing = 0, around_the_eye = 0, empty = 0;
  for (int k = 0; k < 4000; ++k) {
    const Camera c = random_camera(random, k % 4 == 0);
    const double aspect = random.in(0.5, 2.5);
    const Ball ball = ball_of(random, c);
    const ScreenBounds bounds = screen_bounds(c, aspect, ball);
    const double depth = view_of(c, ball.centre).z;
    crossing += std::abs(depth - c.near) < ball.radius;
    around_the_eye += glm::distance(ball.centre, c.position) < ball.radius;
    empty += bounds.empty();
    EXPECT_EQ(bounds.empty(), depth + ball.radius <= c.near);
    for (int i = 0; i < 60; ++i) {
      // Half of the points on the surface, where bounds are decided.
      const double r = ball.radius * (i % 2 ? 1 : std::cbrt(random.in(0, 1)));
      const Projected p = project(c, aspect, ball.centre + random_direction(random) * r);
      if (p.depth < c.near) continue;
      ++seen;
      ASSERT_TRUE(inside(bounds, p.ndc)) << fmt::format("{}: {} {} at depth {} is outside of {}", k, p.ndc.x, p.ndc.y,
                                                        p.depth, text(bounds));
    }
  }
  EXPECT_GT(seen, 50000);
  for (const int cases : {crossing, around_the_eye, empty}) EXPECT_GT(cases, 200);
}

// The outline by brute force: the tangent cone's circle of contact in many steps, or all of the sphere's rim.
ScreenBounds brute_force(const Camera& c, double aspect, const Ball& ball) {
  const glm::dvec3 to_centre = c.orthographic() ? c.forward() : ball.centre - c.position;
  const double d = glm::length(to_centre), s = c.orthographic() ? 0 : ball.radius / d;
  const glm::dvec3 axis = to_centre / d;
  const glm::dvec3 u = glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : c.right()));
  const glm::dvec3 v = glm::cross(axis, u), middle = ball.centre - axis * (ball.radius * s);
  const double rim = ball.radius * std::sqrt(1 - s * s);
  ScreenBounds out{{1e9, 1e9}, {-1e9, -1e9}};
  constexpr int kSteps = 8192;
  for (int i = 0; i < kSteps; ++i) {
    const double turn = 2 * 3.14159265358979 * i / kSteps;
    const glm::dvec2 p = project(c, aspect, middle + rim * (std::cos(turn) * u + std::sin(turn) * v)).ndc;
    out.from = glm::min(out.from, p), out.to = glm::max(out.to, p);
  }
  return out;
}

TEST(ScreenBoundsOf, ABallInFullViewAreItsOutlines) {
  Pcg32 random(4);
  int compared = 0;
  while (compared < 400) {
    const Camera c = random_camera(random, compared % 4 == 0);
    const double aspect = random.in(0.5, 2.5);
    Ball ball = ball_of(random, c);
    ball.centre += c.forward() * (3 * ball.radius);
    const ScreenBounds bounds = screen_bounds(c, aspect, ball);
    const bool in_view = largest(glm::max(-bounds.from, bounds.to)) < 1;
    if (!in_view || view_of(c, ball.centre).z - ball.radius < c.near) continue;
    ++compared;
    const ScreenBounds expected = brute_force(c, aspect, ball);
    EXPECT_LT(glm::length(bounds.from - expected.from), 1e-6) << text(bounds) << " is not " << text(expected);
    EXPECT_LT(glm::length(bounds.to - expected.to), 1e-6) << text(bounds) << " is not " << text(expected);
  }
}

// Where the near plane cuts, too: not one of the four sides can be moved in by a thousandth of the bounds.
TEST(ScreenBoundsOf, ABallThatTheNearPlaneCutsAreTight) {
  Pcg32 random(5);
  int compared = 0;
  while (compared < 60) {
    const Camera c = random_camera(random, compared % 4 == 0);
    const Ball ball = ball_of(random, c);
    if (std::abs(view_of(c, ball.centre).z - c.near) > 0.9 * ball.radius) continue;
    ++compared;
    const ScreenBounds bounds = screen_bounds(c, 1, ball);
    // Points of the surface and of the disc that the near plane cuts out.
    const double depth = view_of(c, ball.centre).z, cut = c.near - depth;
    const double width = std::sqrt(ball.radius * ball.radius - cut * cut);
    ScreenBounds points{{1e9, 1e9}, {-1e9, -1e9}};
    const auto add = [&](const glm::dvec3& world) {
      const Projected p = project(c, 1, world);
      if (p.depth >= c.near - 1e-9) points.from = glm::min(points.from, p.ndc), points.to = glm::max(points.to, p.ndc);
    };
    for (int i = 0; i < 200000; ++i) add(ball.centre + random_direction(random) * ball.radius);
    for (int i = 0; i < 4096; ++i) {
      const double turn = 2 * 3.14159265358979 * i / 4096;
      add(ball.centre + c.forward() * cut + width * (std::cos(turn) * c.right() + std::sin(turn) * c.up()));
    }
    const glm::dvec2 size = bounds.to - bounds.from;
    EXPECT_LT(largest((points.from - bounds.from) / size), 1e-3) << text(bounds) << " for " << text(points);
    EXPECT_LT(largest((bounds.to - points.to) / size), 1e-3) << text(bounds) << " for " << text(points);
  }
}

Light spot_of(Pcg32& random) {
  Light l;
  l.kind = LightKind::spot;
  l.position = random_direction(random) * random.in(0, 20);
  l.direction = random_direction(random);
  l.range = random.in(0.1, 12);
  l.outer_cos = std::cos(random.in(0, 3.14159));
  return l;
}

TEST(ReachOf, ASpotHoldsItsConeAndNeverMoreThanItsRange) {
  Pcg32 random(6);
  int reached = 0;
  for (int k = 0; k < 2000; ++k) {
    const Light l = spot_of(random);
    const Ball ball = reach_of(l);
    EXPECT_LE(ball.radius, l.range * (1 + 1e-12));
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 away = random_direction(random);
      if (glm::dot(away, l.direction) <= l.outer_cos) continue;
      ++reached;
      const double r = l.range * (i % 2 ? 1 : random.in(0, 1));
      EXPECT_LE(glm::distance(l.position + away * r, ball.centre), ball.radius * (1 + 1e-9));
    }
  }
  EXPECT_GT(reached, 10000);
  Light narrow = spot_of(random);
  narrow.outer_cos = std::cos(0.2);
  EXPECT_NEAR(reach_of(narrow).radius, narrow.range / (2 * std::cos(0.2)), 1e-12);
}

TEST(ScreenBoundsOf, ALightAreClippedToTheScreenAndWholeWithoutEnd) {
  const Camera c;
  Light l;
  const auto bounds = [&] { return screen_bounds(c, 1.5, l); };
  EXPECT_EQ(bounds().area(), 4) << "endless";
  l.range = 5, l.kind = LightKind::directional;
  EXPECT_EQ(bounds().area(), 4) << "directional";
  l.kind = LightKind::point;
  EXPECT_EQ(bounds().area(), 4) << "the camera is inside";
  l.position = {0, 0, 100};
  EXPECT_TRUE(bounds().empty()) << "behind";
  l.position = {300, 0, -100};
  EXPECT_TRUE(bounds().empty()) << "beside";
  EXPECT_EQ(bounds().area(), 0);
  l.position = {62, 0, -100};  // the picture's right border is at 62.1
  EXPECT_EQ(bounds().to.x, 1);
  EXPECT_NEAR(bounds().from.x, 57.0 / 62.1, 0.02);
  l.range = 0;
  EXPECT_TRUE(bounds().empty()) << "reaches nothing";
}

}  // namespace
}  // namespace gbl
