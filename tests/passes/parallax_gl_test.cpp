// Surfaces below their triangles: what is drawn against the exact height field, and all passes against each other.
#include "app/stability_bench.h"
#include "renderer/frame/validate.h"
#include "renderer/passes/judging.h"
#include "tests/passes/along_the_wall.h"

namespace gbl::test {
namespace {

class ParallaxGl : public GlTest {
 protected:
  static StabilityBench& bench() {
    static Renderer renderer;
    static StabilityBench b(renderer, gl::probe_device({}));
    return b;
  }
};

double mean_degrees(const Measured& m) {
  double sum = 0;
  size_t n = 0;
  for (size_t i = 0; i < m.truth->pixels(); ++i) {
    if (!m.truth->present[i]) continue;
    const double cosine = glm::dot(glm::normalize(glm::dvec3(m.drawn.normal[i])), m.truth->normal[i]);
    sum += glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))), ++n;
  }
  return sum / double(n);
}

double most_off(const Measured& m, double share) {  // units that so many pixels are within
  std::vector<double> off;
  for (size_t i = 0; i < m.truth->pixels(); ++i)
    if (m.truth->present[i]) off.push_back(glm::distance(glm::dvec3(m.drawn.position[i]), m.truth->position[i]));
  std::sort(off.begin(), off.end());
  return off[static_cast<size_t>(share * double(off.size() - 1))];
}

TEST_F(ParallaxGl, EachMethodComesNearerThanTheOneBefore) {
  SweepSetup s{along_the_wall(), room()};
  s.settings.parallax.steps = 16;
  double before = 1e9;
  for (const ParallaxMethod m :
       {ParallaxMethod::none, ParallaxMethod::offset, ParallaxMethod::steep, ParallaxMethod::occlusion}) {
    s.settings.parallax.method = m;
    const double off = mean_degrees(bench().measure(s));
    EXPECT_LT(off, 0.8 * before) << row(m).id;
    before = off;
  }
}

// Steps finer than a texel's height leave what float and the sampler round: no more.
TEST_F(ParallaxGl, ManyStepsEndAtTheTruth) {
  SweepSetup s{along_the_wall(), room()};
  s.settings.parallax = {ParallaxMethod::relief, 512, ParallaxDepth::displaced};
  const Measured m = bench().measure(s);
  EXPECT_LT(mean_degrees(m), 0.01);
  EXPECT_LT(most_off(m, 0.999), 1e-4) << "the wall is 0.028 deep, and 7 units away";
}

TEST_F(ParallaxGl, DepthIsStoredWhereTheSurfaceIsSeenOrOnTheTriangle) {
  SweepSetup s{along_the_wall(), room()};
  const double displaced = most_off(bench().measure(s), 0.9);
  s.settings.parallax.depth = ParallaxDepth::flat;
  const double flat = most_off(bench().measure(s), 0.9);
  EXPECT_LT(displaced, 1e-3);
  EXPECT_GT(flat, 0.01);
  // Where positions are stored apart from depth, too.
  s.settings.position.source = PositionSource::view32f;
  EXPECT_NEAR(most_off(bench().measure(s), 0.9), flat, 1e-4);
  s.settings.parallax.depth = ParallaxDepth::displaced;
  EXPECT_LT(most_off(bench().measure(s), 0.9), 1e-3);
}

// Passes that draw objects a second time find the depth of the first.
TEST_F(ParallaxGl, AllMethodsOfLightingShowOnePicture) {
  SweepSetup s{along_the_wall(), room()};
  s.settings.lights.method = LightMethod::fullscreen;
  const std::vector<glm::vec3> expected = bench().measure(s).drawn.lit;
  for (const LightMethod m : {LightMethod::forward, LightMethod::forward_prepass, LightMethod::forward_multipass,
                              LightMethod::prepass, LightMethod::volumes, LightMethod::clustered}) {
    s.settings.lights.method = m;
    if (m == LightMethod::prepass) s.settings.accumulation.targets = AccumulationTargets::split;
    const std::vector<glm::vec3> lit = bench().measure(s).drawn.lit;
    size_t off = 0;
    for (size_t i = 0; i < lit.size(); ++i)
      off += glm::distance(lit[i], expected[i]) > 2e-3f * (1 + glm::length(expected[i]));
    // A line of sight that just touches a brick's edge ends before or behind it by a rounding.
    EXPECT_LE(off, 2u) << row(m).id;
  }
}

// A scene without height maps does not know the setting.
TEST_F(ParallaxGl, WhereThereIsNoHeightMapNothingChanges) {
  const auto scene = std::make_shared<const Scene>(build_spheres());
  const GpuScene gpu(scene);
  Renderer renderer;
  Targets off, on;
  Settings s = float_settings(*scene);
  s.camera = scene->camera, s.size = {160, 90};
  const int calls = renderer.render(s, gpu, off).draw_calls;
  s.height_map = HeightMap::on;
  EXPECT_EQ(renderer.render(s, gpu, on).draw_calls, calls);
  EXPECT_EQ(gl::read_rgba32f(*off.frame.texture(Stores::lit)), gl::read_rgba32f(*on.frame.texture(Stores::lit)));
}

// Shadow maps sink surfaces, too: else all that lies below a triangle would be in its shadow.
TEST_F(ParallaxGl, ASunkenWallIsNotInItsOwnShadow) {
  SweepSetup s{along_the_wall(), room()};
  s.settings.shadows = Shadows::all;
  s.settings.shadow.map_size = ShadowMapSize::s2048;
  const Measured m = bench().measure(s);
  size_t dark = 0, lit = 0;
  for (size_t i = 0; i < m.truth->pixels(); ++i) {
    const double is = glm::dot(glm::dvec3(m.drawn.lit[i]), glm::dvec3(1)),
                 should = glm::dot(m.truth->lit[i], glm::dvec3(1));
    dark += is<0.7 * should, lit += should> 0.05;
  }
  EXPECT_GT(lit, 5000u);
  EXPECT_LT(dark, lit / 50);
}

}  // namespace
}  // namespace gbl::test
