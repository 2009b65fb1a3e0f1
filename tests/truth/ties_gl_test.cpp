// Ties of whole frames: the sound first screen has some and is small in error without them; nothing broken hides in them.
#include "renderer/truth/ties.h"

#include "app/lab.h"
#include "tests/pitfalls/judged.h"

namespace gbl::test {
namespace {

class TiesGl : public GlTest {
 protected:
  static Settings start() {
    Settings s = preset("start").make();
    s.size = {640, 360};
    return s;
  }
};

size_t others_seen(const TruthSet& set, const Drawn& drawn) {
  size_t n = 0;
  for (size_t i = 0; i < drawn.seen.size(); ++i) n += drawn.seen[i] != set.texels[i].surface();
  return n;
}

// Its depth runs forward, so where surfaces cut each other some pixels show the other one than the reference. The second
// size is the first window's: there two parts of a cow lie .012 units apart and show a difference of 215 codes.
TEST_F(TiesGl, TheFirstScreenIsRightButForTies) {
  for (const glm::ivec2 size : {glm::ivec2(640, 360), glm::ivec2(1200, 675)}) {
    Settings s = start();
    s.size = size;
    const auto set = truth_of(s, terrain());
    Stage& stage = shared_stage(terrain());
    stage.draw(s);
    const Drawn drawn = read_drawn(stage.renderer, s, terrain(), stage.targets, false);
    const Errors e = measure(set->truth, drawn, {s.exposure, s.colour});
    EXPECT_GT(*e.tie_pixels, 0);
    EXPECT_EQ(*e.tie_pixels, static_cast<double>(others_seen(*set, drawn)));
    EXPECT_LT(*e.normal_deg_max, 1);
    EXPECT_LT(*e.max_linear, 0.1);
  }
}

TEST_F(TiesGl, ALostLightIsNotExcused) {
  Settings s = start();
  s.lights.cull = LightCull::back;
  const Errors e = errors_of(s, terrain());
  EXPECT_GT(*e.max_linear, 0.5);
  EXPECT_EQ(e.tie_pixels, errors_of(start(), terrain()).tie_pixels) << "lights do not move edges";
}

// Every pixel in which the depth test has picked a hidden surface is off; few of them lie at an edge.
TEST_F(TiesGl, ADepthThatIsTooCoarseIsNotExcused) {
  Settings s = start();
  s.depth.format = DepthFormat::d16;
  const Errors e = errors_of(s, terrain());
  EXPECT_GT(*e.normal_deg_max, 45);
  EXPECT_GT(*e.max_linear, 0.5);
}

TEST_F(TiesGl, AveragedSurfacesAreNotExcused) {
  Settings s = start();
  s.antialias = Antialias::msaa_resolved;
  const Errors e = errors_of(s, terrain());
  EXPECT_GT(*e.normal_deg_max, 45);
  EXPECT_EQ(e.tie_pixels, 0) << "a mean of surfaces is none of them";
}

// A box stands a tenth of its width aside of where it should: a strip of pixels on either side shows the wrong surface.
TEST_F(TiesGl, AnObjectInAnotherPlaceIsNotExcused) {
  const Settings s = settings_for(yard());
  Scene moved = make_yard();
  moved.instances[1].world_from_object[3].x += 0.3;
  const GpuScene moved_scene(std::make_shared<const Scene>(moved));
  const auto set = truth_of(s, yard());
  Stage& stage = shared_stage(moved_scene);
  stage.draw(s);
  const Drawn drawn = read_drawn(stage.renderer, s, moved_scene, stage.targets, false);
  const Errors e = measure(set->truth, drawn, {s.exposure, s.colour});
  const size_t others = others_seen(*set, drawn);
  EXPECT_GT(others, 20u);
  EXPECT_LT(*e.tie_pixels, 0.2 * static_cast<double>(others));
  EXPECT_GT(*e.position_max, 1);
  EXPECT_GT(*e.max_linear, 0.1);
}

// The view, its numbers, the study's columns and the account of one pixel tell the same pixels.
TEST_F(TiesGl, OneRuleServesThemAll) {
  Lab lab{FeatureSet{}};
  Settings s = start();
  s.view.error.of = ErrorOf::normal;
  lab.draw(s);
  ASSERT_TRUE(lab.draw_truth_view(View::error, true));
  const ErrorStats stats = lab.error_stats().value();
  EXPECT_EQ(static_cast<double>(stats.ties), errors_of(s, terrain()).tie_pixels);
  EXPECT_LT(stats.max, 1);

  const Image picture = lab.image_of(View::error);
  const glm::u8vec3 colour(glm::round(255.0f * kTieColour));
  size_t shown = 0;
  for (int y = 0; y < s.size.y; ++y)
    for (int x = 0; x < s.size.x; ++x) {
      const uint8_t* p = &picture.rgba[4 * static_cast<size_t>(y * s.size.x + x)];
      if (glm::u8vec3(p[0], p[1], p[2]) != colour) continue;
      ++shown;
      EXPECT_NE(glm::ivec2(x, y), stats.worst);
      lab.start_probe({x, y});
      const PixelAccount a = lab.account(lab.take_probe(true).value(), true).value();
      EXPECT_TRUE(a.tie) << x << ", " << y;
      EXPECT_TRUE(a.shown != a.seen) << x << ", " << y;
      EXPECT_EQ(other_surface_note(a).rfind("an edge", 0), 0u) << other_surface_note(a);
    }
  EXPECT_EQ(shown, stats.ties);
}

}  // namespace
}  // namespace gbl::test
