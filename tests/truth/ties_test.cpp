// Which surfaces are seen one step of the rasteriser's grid beside a pixel's centre.
#include "renderer/truth/ties.h"

#include "renderer/truth/reference.h"
#include "renderer/truth/visible_triangles.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

// Upright triangles that face +Z: objects 1, 2, ... in the order they are added.
class Cards {
 public:
  Cards() { scene_.materials = {{}}; }
  // Left of x, over the whole picture's height.
  Cards& left_of(double x, float z) { return add({x, 100, z}, {-100, 0, z}, {x, -100, z}); }
  Cards& everywhere(float z) { return add({0, 100, z}, {-100, -100, z}, {100, -100, z}); }
  const Scene& scene() const { return scene_; }

 private:
  Cards& add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const int mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back({"card", {corner(a), corner(b), corner(c)}, {0, 1, 2}});
    scene_.instances.push_back({"card", mesh, 0, glm::dmat4(1)});
    return *this;
  }
  Scene scene_;
};

// A pixel is a unit of the world; the centre of pixel (8, 8) lies at x = 0.5.
Settings from_the_front() {
  Settings s = closed_settings({16, 16});
  s.camera.position = {0, 0, 50};
  s.camera.orientation = orientation_from_yaw_pitch(0, 0);
  s.camera.orthographic_height = 16;
  return s;
}
constexpr double kCentre = 0.5;
constexpr size_t kPixel = 8 * 16 + 8;
constexpr SeenSurface kBackground{0, 0}, kFirst{1, 0}, kSecond{2, 0}, kThird{3, 0};

Truth judged(const Cards& cards) {
  const Settings s = from_the_front();
  std::vector<SeenSurface> seen;
  for (const SeenTexel& t : visible_triangles(s, cards.scene(), false)) seen.push_back(t.surface());
  Truth t{.size = s.size};
  t.rivals = rivals_of(s, cards.scene(), seen);
  return t;
}

TEST(Ties, AnEdgeWithinAStepOfTheCentreMakesOne) {
  for (const double aside : {0.9, 0.1, -0.1, -0.9}) {
    const Truth t = judged(Cards().left_of(kCentre + aside * kRasterPx, 1).everywhere(0));
    const bool covered = aside > 0;
    EXPECT_EQ(is_tie(t, kPixel, kFirst), !covered) << aside;
    EXPECT_EQ(is_tie(t, kPixel, kSecond), covered) << aside;
    EXPECT_EQ(t.rivals.size(), 16u) << "the edge's column, and each rival once";
  }
}

TEST(Ties, AnEdgeFartherAwayExcusesNothing) {
  for (const double aside : {1.1, -1.1, 4.0}) {
    const Truth t = judged(Cards().left_of(kCentre + aside * kRasterPx, 1).everywhere(0));
    EXPECT_FALSE(is_tie(t, kPixel, kFirst)) << aside;
    EXPECT_FALSE(is_tie(t, kPixel, kSecond)) << aside;
  }
}

TEST(Ties, WhatIsHiddenOnBothSidesIsWrong) {
  const Truth t = judged(Cards().left_of(kCentre + 0.5 * kRasterPx, 2).everywhere(1).everywhere(0));
  EXPECT_TRUE(is_tie(t, kPixel, kSecond));
  EXPECT_FALSE(is_tie(t, kPixel, kThird));
  EXPECT_FALSE(is_tie(t, kPixel, kBackground));
  EXPECT_FALSE(is_tie(t, kPixel, {2, 1})) << "another triangle of the same object";
  EXPECT_FALSE(is_tie(t, kPixel, {-1, -1})) << "what the frame shows is not known";
  EXPECT_FALSE(is_tie(t, kPixel + 1, kSecond)) << "the neighbour is a pixel away";
}

TEST(Ties, SurfacesThatNearlyTouchMakeOneAnywhere) {
  const double range = from_the_front().camera.position.z;
  for (const double behind : {0.0, 0.5, 0.9}) {
    const Truth t = judged(Cards().everywhere(0).everywhere(-behind * kSameRange * range));
    EXPECT_EQ(t.rivals.size(), 256u) << behind;
    EXPECT_TRUE(is_tie(t, kPixel, kSecond)) << behind;
  }
  EXPECT_TRUE(judged(Cards().everywhere(0).everywhere(-1.1 * kSameRange * range)).rivals.empty());
}

TEST(Ties, TheBackgroundIsASurfaceLikeOthers) {
  const Truth t = judged(Cards().left_of(kCentre + 0.5 * kRasterPx, 0));
  EXPECT_TRUE(is_tie(t, kPixel, kBackground));
  EXPECT_FALSE(is_tie(t, kPixel, kFirst)) << "the surface that the reference sees is right";
}

// Where the driver has decided otherwise than the double does at the very centre, that is a rival, too.
TEST(Ties, TheCentreItselfIsLookedAt) {
  const Cards cards = Cards().everywhere(0);
  Settings s = from_the_front();
  const std::vector<SeenSurface> driver(256, kSecond);
  Truth t{.size = s.size};
  t.rivals = rivals_of(s, cards.scene(), driver);
  EXPECT_TRUE(is_tie(t, kPixel, kFirst));
  EXPECT_EQ(t.rivals.size(), 256u);
}

TEST(Ties, AreGivenUpWhenCancelledAndGoOnWhereTimeWasUp) {
  const Settings s = from_the_front();
  const auto scene = std::make_shared<const Scene>(Cards().everywhere(0).scene());
  const std::vector<SeenSurface> driver(256, kSecond);
  std::vector<SeenTexel> texels(driver.size());
  for (size_t i = 0; i < driver.size(); ++i) texels[i].seen = glm::vec4(driver[i].object, driver[i].triangle, 0, 0);
  Reference reference(s, scene, texels);
  std::atomic<bool> cancel{true};
  EXPECT_FALSE(reference.find_rivals(&cancel));
  EXPECT_TRUE(reference.truth().rivals.empty());
  cancel = false;
  int calls = 0;
  while (!reference.find_rivals(&cancel, 0)) ++calls;
  EXPECT_EQ(calls, kRivalPlaces);
  EXPECT_EQ(reference.truth().rivals, rivals_of(s, *scene, driver));
  EXPECT_EQ(reference.truth().rivals.size(), 256u);
}

}  // namespace
}  // namespace gbl::test
