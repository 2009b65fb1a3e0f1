// What the reference sees in mirrors and through glass, where the answer is known in closed form.
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "renderer/scenes/mesh_builder.h"
#include "renderer/truth/mirror_sight.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

// A level mirror, and above it a shining square that faces down. Each pixel of the mirror shows it where the line from the
// camera's image meets it.
TEST(MirrorTruth, ShowsASquareWhereItsImageIs) {
  for (const double k : {1e-3, 1.0, 1e3, 1e6}) {
    Scene scene = make_plane(static_cast<float>(20 * k), Material{.name = "mirror", .roughness = 0, .metal = 1});
    scene.meshes.push_back(make_plane(static_cast<float>(k)).meshes[0]);
    scene.materials.push_back({.name = "shines", .base_colour = {0, 0, 0, 1}, .emissive = {0.5f, 0.25f, 0.75f}});
    const glm::dvec3 square(0.5 * k, 2 * k, -k);
    const glm::dmat4 down = glm::rotate(glm::translate(glm::dmat4(1), square), glm::radians(180.0), {1, 0, 0});
    scene.instances.push_back({"square", 1, 1, down});
    scene.bounds = bounds_of(scene);
    Settings s = closed_settings({96, 54});
    s.reflections = Reflections::on;
    s.camera.position = {k, 6 * k, 7 * k};
    s.camera.near = 0.1 * k, s.camera.far = 1000 * k;
    const Truth truth = truth_of(scene, s);
    const glm::dvec3 eye(s.camera.position.x, -s.camera.position.y, s.camera.position.z);
    int shown = 0, empty = 0;
    for (size_t i = 0; i < truth.pixels(); ++i) {
      const glm::dvec3 p = truth.position[i] + s.camera.position;
      if (!truth.present[i] || std::abs(p.y) > 1e-9 * k) continue;
      const glm::dvec3 met = eye + (p - eye) * ((square.y - eye.y) / (p.y - eye.y));
      const double inside = k - std::max(std::abs(met.x - square.x), std::abs(met.z - square.z));
      if (std::abs(inside) < 1e-9 * k) continue;
      EXPECT_LT(glm::distance(truth.lit[i], inside > 0 ? glm::dvec3(0.5, 0.25, 0.75) : glm::dvec3(0)), 1e-9);
      ++(inside > 0 ? shown : empty);
    }
    EXPECT_GT(shown, 20) << k;
    EXPECT_GT(empty, 500) << k;
  }
}

// Without a light: a black surface shows the background by the angle at which it is seen, and nothing of ambient light.
TEST(MirrorTruth, WeighsWhatItShowsByFresnel) {
  Scene scene = make_plane(50, Material{.name = "lacquer", .base_colour = {0, 0, 0, 1}, .roughness = 0.1f});
  Settings s = closed_settings();
  s.reflections = Reflections::on;
  s.shading.model = ShadingModel::ggx;
  s.ambient = 0.7;
  s.background = {BackgroundFill::colour, {2, 3, 4}, BackgroundSkip::depth};
  const Truth truth = truth_of(scene, s);
  int seen = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    const double cosine = -glm::normalize(truth.position[i]).y;
    const double share = 0.04 + 0.96 * std::pow(1 - cosine, 5);
    EXPECT_LT(glm::distance(truth.lit[i], share * glm::dvec3(2, 3, 4)), 1e-9);
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

class Glass : public testing::Test {
 protected:
  // A box of glass, upper side at y = 0, `thick` deep and `wide` to all sides.
  void make(double wide, double thick, float index = 1.5f) {
    scene_ = {};
    scene_.meshes = {make_box({-wide, -thick, -wide}, {wide, 0, wide}, 1)};
    scene_.materials = {{.name = "glass", .roughness = 0, .refraction_index = index, .transmission = 1}};
    scene_.instances = {{"block", 0, 0, glm::dmat4(1)}};
    scene_.bounds = bounds_of(scene_);
    settings_.reflections = Reflections::on;
    settings_.camera.position = {3, 8, 1};
  }
  // Of light that meets the upper side at `at`, seen from above at `degrees` from the normal, towards +X.
  Through through(const glm::dvec3& at, double degrees) const {
    TruthSurface s;
    s.position = at - settings_.camera.position;
    s.normal = {0, 1, 0};
    s.to_eye = {-std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0};
    int triangle = 0;
    while (true) {  // of the upper side
      const uint32_t* c = &scene_.meshes[0].indices[3 * static_cast<size_t>(triangle)];
      if (scene_.meshes[0].vertices[*c].normal.y > 0.5f) break;
      ++triangle;
    }
    return MirrorSight(settings_, scene_, nullptr, nullptr).refracted_rays(s, {1, triangle});
  }
  Scene scene_;
  Settings settings_;
};

TEST_F(Glass, ASlabShiftsARaySideways) {
  for (const double thick : {0.01, 1.0, 5.0})
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 85.0}) {
      make(100, thick);
      const Through t = through({0.3, 0, 0.1}, degrees);
      const double sine = std::sin(glm::radians(degrees)), cosine = std::cos(glm::radians(degrees));
      const glm::dvec3 along(sine, -cosine, 0);
      EXPECT_LT(glm::distance(t.rays.ray.direction, along), 1e-9) << "it leaves as it came";
      const glm::dvec3 out = t.rays.ray.origin + settings_.camera.position;
      EXPECT_NEAR(out.y, -thick, 1e-9);
      const double shift = thick * sine * (1 - cosine / std::sqrt(1.5 * 1.5 - sine * sine));
      const glm::dvec3 straight = glm::dvec3(0.3, 0, 0.1) + along * (thick / cosine);
      EXPECT_NEAR((straight.x - out.x) * cosine, shift, 1e-9 * std::max(1.0, thick));
      const double lost = 0.04 + 0.96 * std::pow(1 - cosine, 5);
      EXPECT_NEAR(t.share, 1 - lost, 1e-9);
    }
}

// From above towards a side: beyond the critical angle it is mirrored within, and leaves below, turned round.
TEST_F(Glass, BeyondTheCriticalAngleASideMirrorsWithin) {
  make(1, 2);
  const Through t = through({0.9, 0, 0}, 60);
  const double sine = std::sin(glm::radians(60.0)) / 1.5;
  ASSERT_GT(std::cos(std::asin(sine)), 1 / 1.5) << "what meets the side is beyond it";
  EXPECT_LT(
      glm::distance(t.rays.ray.direction, glm::dvec3(-std::sin(glm::radians(60.0)), -std::cos(glm::radians(60.0)), 0)),
      1e-9);
  const glm::dvec3 out = t.rays.ray.origin + settings_.camera.position;
  const double run = 2 * sine / std::sqrt(1 - sine * sine);  // sideways, unfolded
  EXPECT_NEAR(out.x, 1 - (0.9 + run - 1), 1e-9);
  EXPECT_NEAR(out.y, -2, 1e-9);
}

TEST_F(Glass, WithTheAirsIndexNothingIsBent) {
  make(100, 2, 1);
  const Through t = through({0, 0, 0}, 50);
  const glm::dvec3 along(std::sin(glm::radians(50.0)), -std::cos(glm::radians(50.0)), 0);
  EXPECT_LT(glm::distance(t.rays.ray.direction, along), 1e-12);
  EXPECT_NEAR(t.share, 1, 1e-12);
}

}  // namespace
}  // namespace gbl::test
