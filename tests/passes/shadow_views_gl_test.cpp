// What the views of shadows show is what the lighting reads.
#include "app/lab.h"
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

TEST_F(ShadowViews, WithoutShadowsTheySayWhatIsMissing) {
  settings_.shadows = Shadows::off;
  EXPECT_NE(why_missing(View::visibility, settings_), "");
  EXPECT_NE(why_missing(View::shadow_maps, settings_), "");
}

}  // namespace
}  // namespace gbl::test
