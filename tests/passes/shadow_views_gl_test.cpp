// What the views of shadows show is what the lighting reads.
#include <set>
#include <utility>

#include "app/lab.h"
#include "renderer/opening/scene_look.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class ShadowViews : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
    lab_->show("test:yard", std::make_shared<const Scene>(make_yard()));
    settings_ = settings_for(yard());
    settings_.scene = "test:yard";
    settings_.lights.count = 1, settings_.lights.range_scale = 3;
    settings_.shadows = Shadows::all;
    settings_.ambient = 0, settings_.background.fill = BackgroundFill::black;
  }
  std::unique_ptr<Lab> lab_;
  Settings settings_;
};

TEST_F(ShadowViews, VisibilityIsTheShareOfTheLightThatIsDrawn) {
  lab_->draw(settings_);
  const std::vector<glm::vec4> seen = lab_->numbers_of(View::visibility), lit = lab_->numbers_of(View::lit);
  Settings without = settings_;
  without.shadows = Shadows::off;
  lab_->draw(without);
  const std::vector<glm::vec4> all = lab_->numbers_of(View::lit);
  int hidden = 0, whole = 0;
  for (size_t i = 0; i < lit.size(); ++i) {
    if (!(all[i].g > 1e-3f)) continue;
    EXPECT_NEAR(lit[i].g, seen[i].r * all[i].g, 1e-4f * all[i].g + 1e-6f) << "pixel " << i;
    hidden += seen[i].r == 0, whole += seen[i].r == 1;
  }
  EXPECT_GT(hidden, 200);
  EXPECT_GT(whole, 1000);
}

// The light stands 3 units above the ground in the middle: its face -Y, the fourth, sees the ground at 3 of its range.
TEST_F(ShadowViews, MapsShowDistancesOfTheirFaces) {
  lab_->draw(settings_);
  const std::vector<glm::vec4> shares = lab_->numbers_of(View::shadow_maps);
  const ShadowPlan plan = lab_->resolve(settings_)->shadows;
  ASSERT_EQ(plan.maps.size(), 6u);
  const double tile = double(settings_.size.x) * plan.map_texels / plan.size.x;
  const auto middle =
      static_cast<size_t>(tile / 2) * static_cast<size_t>(settings_.size.x) + static_cast<size_t>(3.5 * tile);
  const Light light = lab_->lights().at(0);
  double farthest = 0;
  for (const glm::dvec3& c : corners_of(yard().scene().bounds))
    farthest = std::max(farthest, glm::distance(c, light.position));
  EXPECT_NEAR(shares[middle].r, 3 / std::min(light.range, 1.01 * farthest), 0.003);
}

// The axis along which a point is farthest from the lamp names its map, and that distance the width of a texel there.
TEST_F(ShadowViews, MapsAndTexelsAreThoseOfThePlan) {
  lab_->draw(settings_);
  const std::vector<glm::vec4> maps = lab_->numbers_of(View::shadow_map_read),
                               texels = lab_->numbers_of(View::shadow_texel),
                               positions = lab_->numbers_of(View::position);
  const ShadowPlan plan = lab_->resolve(settings_)->shadows;
  const Light light = lab_->lights().at(0);
  const Camera& c = settings_.camera;
  const double pixel = 2 * std::tan(glm::radians(c.fov) / 2) / settings_.size.y;
  std::set<int> read;
  for (size_t i = 0; i < maps.size(); ++i) {
    if (positions[i].a == 0) continue;
    const glm::dvec3 place(positions[i]), from = place - light.position;
    if (std::abs(glm::length(from) - light.range) < 1e-3) continue;
    if (glm::length(from) > light.range) {
      EXPECT_EQ(maps[i].r, -1);
      EXPECT_EQ(texels[i].r, -1);
      continue;
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(from[k]) > std::abs(from[axis])) axis = k;
    glm::dvec3 rest = glm::abs(from);
    const double most = std::exchange(rest[axis], 0.0);
    if (most - std::max({rest.x, rest.y, rest.z}) < 1e-3) continue;  // at an edge of the cube
    const int face = 2 * axis + (from[axis] < 0);
    EXPECT_EQ(maps[i].r, static_cast<float>(face)) << "pixel " << i;
    const double width = plan.maps[static_cast<size_t>(face)].texel * most;
    EXPECT_NEAR(texels[i].r, width / (pixel * glm::dot(place - c.position, c.forward())), 1e-3 * double(texels[i].r));
    read.insert(face);
  }
  EXPECT_GE(read.size(), 4u);
}

TEST_F(ShadowViews, CascadesFollowTheDepth) {
  const auto scene = open_scene("builtin:bias");
  lab_->show("builtin:bias", scene);
  apply_scene(settings_, "builtin:bias", *scene);
  settings_.lights.source = LightSource::scene;  // the first is the sun
  settings_.view.pick = 0;
  lab_->draw(settings_);
  const std::vector<glm::vec4> maps = lab_->numbers_of(View::shadow_map_read), depth = lab_->numbers_of(View::depth);
  const ShadowPlan plan = lab_->resolve(settings_)->shadows;
  std::set<int> read;
  for (size_t i = 0; i < maps.size(); ++i) {
    if (depth[i].a == 0) continue;
    int cascade = 0;
    bool at_a_seam = false;
    for (int k = 0; k + 1 < settings_.shadow.cascades; ++k) {
      const double up_to = plan.maps[static_cast<size_t>(k)].up_to;
      cascade += double(depth[i].r) >= up_to, at_a_seam |= std::abs(double(depth[i].r) - up_to) < 1e-3 * up_to;
    }
    if (at_a_seam) continue;
    EXPECT_EQ(maps[i].r, static_cast<float>(cascade)) << "pixel " << i;
    read.insert(cascade);
  }
  EXPECT_GE(read.size(), 2u);
}

TEST_F(ShadowViews, WithoutShadowsTheySayWhatIsMissing) {
  settings_.shadows = Shadows::off;
  EXPECT_NE(why_missing(View::visibility, settings_), "");
  EXPECT_NE(why_missing(View::shadow_maps, settings_), "");
}

}  // namespace
}  // namespace gbl::test
