// Shadow maps against the exact shadows of the reference.
#include <set>

#include "app/stability_bench.h"
#include "renderer/frame/validate.h"
#include "renderer/passes/judging.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class ShadowsGl : public GlTest {
 protected:
  static StabilityBench& bench() {
    static Renderer renderer;
    static StabilityBench b(renderer, gl::probe_device({}));
    return b;
  }
};

Light point_at(const glm::dvec3& at, double range) {
  Light l;
  l.position = at, l.range = range;
  return l;
}
Light sun_along(const glm::dvec3& direction) {
  Light l;
  l.kind = LightKind::directional;
  l.direction = glm::normalize(direction);
  return l;
}
Light spot_at(const glm::dvec3& at, const glm::dvec3& direction, double range) {
  Light l = point_at(at, range);
  l.kind = LightKind::spot;
  l.direction = glm::normalize(direction);
  l.inner_cos = std::cos(0.6), l.outer_cos = std::cos(0.8);
  return l;
}

// The yard of the tests under these lights, everything but the shadows exact.
SweepSetup yard_under(const char* name, std::vector<Light> lights, Shadows shadows = Shadows::all) {
  auto scene = std::make_shared<Scene>(make_yard());
  scene->name = name, scene->lights = std::move(lights);
  Settings s = float_settings(*scene);
  s.shading.model = ShadingModel::lambert;
  s.attenuation = Attenuation::none, s.range.kind = RangeKind::none;
  s.ambient = 0, s.exposure = 1;
  s.shadows = shadows;
  return {s, scene};
}
SweepSetup sunny() { return yard_under("test:sunny", {sun_along({0.5, -1, -0.4})}); }
SweepSetup lamp_lit() { return yard_under("test:lamp", {point_at({16, 8, 18}, 60)}); }
SweepSetup spot_lit() { return yard_under("test:spot", {spot_at({18, 12, 30}, {0.1, -0.8, -0.5}, 60)}); }

double wrong(const Errors& e) { return *e.shadow_lit_pixels + *e.shadow_dark_pixels; }

// Pixels whose shadow is another within `reach` pixels of them: where a map may be wrong by a texel or two.
size_t pixels_near_an_edge(const Truth& t, int reach) {
  const auto dark = [&](int x, int y) {
    const size_t i = static_cast<size_t>(y * t.size.x + x);
    return t.present[i] ? t.light(i).x < 0.5 * t.unshadowed[i].x : false;
  };
  size_t near = 0;
  for (int y = 0; y < t.size.y; ++y)
    for (int x = 0; x < t.size.x; ++x) {
      bool edge = false;
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const int u = std::clamp(x + dx, 0, t.size.x - 1), v = std::clamp(y + dy, 0, t.size.y - 1);
          edge |= dark(u, v) != dark(x, y);
        }
      near += edge;
    }
  return near;
}

// In all three kinds of light: what is wrong is few pixels, and fewer with more texels.
TEST_F(ShadowsGl, FollowTheTruthAndTheMoreTexelsTheCloser) {
  for (const SweepSetup& setup : {sunny(), lamp_lit(), spot_lit()}) {
    SCOPED_TRACE(setup.settings.scene);
    SweepSetup s = setup;
    s.settings.shadow.map_size = ShadowMapSize::s256;
    const Measured coarse = bench().measure(s);
    s.settings.shadow.map_size = ShadowMapSize::s2048;
    const Measured fine = bench().measure(s);
    size_t dark = 0;
    for (size_t i = 0; i < fine.truth->pixels(); ++i)
      dark += fine.truth->present[i] && fine.truth->unshadowed[i].x > 0.1 && fine.truth->light(i).x == 0;
    EXPECT_GT(dark, 300u) << "there are shadows";
    EXPECT_LT(wrong(fine.errors), 0.05 * static_cast<double>(pixels_near_an_edge(*fine.truth, 1)));
    EXPECT_LT(wrong(fine.errors), 0.5 * wrong(coarse.errors));
  }
}

TEST_F(ShadowsGl, WithoutThemAllHiddenPixelsAreLit) {
  SweepSetup s = lamp_lit();
  s.settings.shadow.max_lights = 0;
  const Errors none = bench().measure(s).errors;
  EXPECT_GT(*none.shadow_lit_pixels, 300);
  EXPECT_EQ(*none.shadow_dark_pixels, 0);
}

TEST_F(ShadowsGl, WithoutABiasSurfacesHideThemselves) {
  for (const SweepSetup& setup : {sunny(), lamp_lit(), spot_lit()}) {
    SCOPED_TRACE(setup.settings.scene);
    SweepSetup s = setup;
    const Errors biased = bench().measure(s).errors;
    s.settings.shadow.bias = 0, s.settings.shadow.slope_bias = 0;
    const Errors acne = bench().measure(s).errors;
    EXPECT_GT(*acne.shadow_dark_pixels, 1000) << "acne";
    EXPECT_LT(*biased.shadow_dark_pixels, 0.05 * *acne.shadow_dark_pixels);
    s.settings.shadow.bias = 200;
    const Errors detached = bench().measure(s).errors;
    EXPECT_GT(*detached.shadow_lit_pixels, *biased.shadow_lit_pixels + 100)
        << "shadows stand apart from what casts them";
  }
}

TEST_F(ShadowsGl, MoreCascadesAreFinerNearby) {
  SweepSetup s = sunny();
  s.settings.shadow.map_size = ShadowMapSize::s256;
  s.settings.shadow.cascades = 1;
  const double one = wrong(bench().measure(s).errors);
  s.settings.shadow.cascades = 4;
  // Not by more: the nearest ground is 20 units away, where the first cascade ends.
  EXPECT_LT(wrong(bench().measure(s).errors), 0.9 * one);
}

TEST_F(ShadowsGl, SunMeansSunsAlone) {
  SweepSetup s = yard_under("test:sun-and-lamp", {sun_along({0.5, -1, -0.4}), point_at({16, 8, 18}, 60)}, Shadows::sun);
  s.settings.shadow.map_size = ShadowMapSize::s2048;
  const Errors e = bench().measure(s).errors;
  EXPECT_LT(wrong(e), 60);
  s.settings.shadows = Shadows::off;
  EXPECT_FALSE(bench().measure(s).errors.shadow_lit_pixels.has_value())
      << "nothing is judged where nothing has a shadow";
}

// Every method takes the same light away: within what their float arithmetic may move a point across a texel's border.
void expect_all_methods_draw_the_same(StabilityBench& bench, SweepSetup s) {
  s.settings.range.kind = RangeKind::source;
  const Measured full = bench.measure(s);
  std::set<std::string> drawn;
  for (const ValueRow& r : rows<LightMethod>()) {
    s.settings.lights.method = static_cast<LightMethod>(r.value);
    if (s.settings.lights.method == LightMethod::auto_ || !sound(s.settings) ||
        !validate(s.settings, bench.limits()).empty())
      continue;
    const Measured m = bench.measure(s);
    size_t differ = 0;
    for (size_t i = 0; i < m.drawn.lit.size(); ++i)
      differ += glm::distance(m.drawn.lit[i], full.drawn.lit[i]) > 1.0f / 255;
    EXPECT_LE(differ, m.drawn.lit.size() / 1000) << r.id;
    drawn.insert(r.id);
  }
  EXPECT_GE(drawn.size(), 8u);
}

TEST_F(ShadowsGl, EveryMethodDrawsTheSameShadows) {
  expect_all_methods_draw_the_same(
      bench(), yard_under("test:methods", {point_at({16, 8, 18}, 30), spot_at({18, 12, 30}, {0.1, -0.8, -0.5}, 40)}));
}

// Few of many have a map, so that loops read some lights as plain ones; the lamps reach far and are read by all.
TEST_F(ShadowsGl, EveryMethodDrawsTheSameShadowsOfAFewOfManyLights) {
  std::vector<Light> lights;
  for (int i = 0; i < 40; ++i) {
    lights.push_back(point_at({3.0 * (i % 8) + 5, 4, 6.0 * (i / 8) + 4}, i % 3 ? 70 : 9));
    lights.back().colour *= 0.05;
  }
  lights[7] = spot_at({18, 12, 30}, {0.1, -0.8, -0.5}, 40);
  lights[21] = sun_along({0.5, -1, -0.4});
  SweepSetup s = yard_under("test:few-of-many", lights);
  s.settings.shadow.max_lights = 3;
  expect_all_methods_draw_the_same(bench(), s);
}

// A walk past a lamp and a sun: maps that are drawn when they change give the bits of maps that are drawn each frame, and a
// lamp's six are drawn once.
TEST_F(ShadowsGl, DrawnWhenTheyChangeTheyAreThoseOfEachFrame) {
  const SweepSetup setup = yard_under("test:walk", {sun_along({0.5, -1, -0.4}), point_at({16, 8, 18}, 60)});
  const GpuScene scene(setup.scene);
  Renderer renderer;
  Targets kept, anew;
  Settings s = setup.settings;
  const auto frame = [&] {
    s.shadow.update = ShadowUpdate::changed;
    const int calls = renderer.render(s, scene, kept).draw_calls;
    s.shadow.update = ShadowUpdate::each_frame;
    const int all_calls = renderer.render(s, scene, anew).draw_calls;
    EXPECT_EQ(read_lit(kept), read_lit(anew));
    return all_calls - calls;  // saved
  };
  EXPECT_EQ(frame(), 0) << "the first frame draws all";
  const int still = frame();
  EXPECT_GT(still, 6) << "and the second none";
  s.camera.position.x += 3;
  const int after_step = frame();
  EXPECT_GT(after_step, 0) << "the lamp's maps are kept";
  EXPECT_LT(after_step, still) << "the sun's follow the camera";
  s.shadow.cull = ShadowCull::front;
  EXPECT_EQ(frame(), 0) << "they hold other faces";
  s.shadow.map_size = ShadowMapSize::s512;
  EXPECT_EQ(frame(), 0);
}

TEST_F(ShadowsGl, DrawnOnceTheyStayBehindTheirLights) {
  SweepSetup s = yard_under("test:once", {});
  s.settings.lights.source = LightSource::generated, s.settings.lights.count = 3;
  s.settings.shadow.update = ShadowUpdate::once;
  const double at_first = wrong(bench().measure(s).errors);
  s.settings.time_s = 20;
  const double later = wrong(bench().measure(s).errors);
  s.settings.shadow.update = ShadowUpdate::changed;
  const double followed = wrong(bench().measure(s).errors);
  EXPECT_GT(later, 4 * at_first);
  EXPECT_GT(later, 4 * followed);
}

// Of six maps the one by the longest axis, or the first that holds the point: the same but where two faces meet.
TEST_F(ShadowsGl, TriedOneByOneTheSixMapsGiveTheSameShadows) {
  SweepSetup s = lamp_lit();
  const Errors by_axis = bench().measure(s).errors;
  s.settings.shadow.point = ShadowPoint::brute_force;
  const Errors tried = bench().measure(s).errors;
  EXPECT_NEAR(wrong(tried), wrong(by_axis), 10);
}

TEST_F(ShadowsGl, LookingAlongTheUpVectorLosesWhatIsAboveAndBelow) {
  SweepSetup s = yard_under("test:high-lamp", {point_at({18, 20, 20}, 60)});
  const double right = *bench().measure(s).errors.shadow_lit_pixels;
  s.settings.mistakes = {Mistake::cube_lookat_up};
  const Errors e = bench().measure(s).errors;
  EXPECT_GT(*e.shadow_lit_pixels, right + 200);
}

TEST_F(ShadowsGl, MapsAreCountedAmongTheTargets) {
  const SweepSetup setup = lamp_lit();
  const GpuScene scene(setup.scene);
  Renderer renderer;
  Targets targets;
  Settings s = setup.settings;
  const double with = renderer.render(s, scene, targets).mib;
  s.shadows = Shadows::off;
  EXPECT_NEAR(with - renderer.render(s, scene, targets).mib, 6 * 4.0, 1e-9) << "six maps of 1024 x 1024 x 4 bytes";
}

TEST_F(ShadowsGl, OffTheirSettingsChangeNoBit) {
  SweepSetup s = lamp_lit();
  s.settings.shadows = Shadows::off;
  const std::vector<glm::vec3> before = bench().measure(s).drawn.lit;
  s.settings.shadow = {.map_size = ShadowMapSize::s256, .cull = ShadowCull::front, .bias = 9, .cascades = 1};
  EXPECT_EQ(bench().measure(s).drawn.lit, before);
}

TEST_F(ShadowsGl, BackFacesAloneLeakWhereASurfaceIsOpen) {
  SweepSetup s = yard_under("test:sheet", {point_at({20, 20, 20}, 60)});
  auto scene = std::make_shared<Scene>(*s.scene);
  Mesh sheet;
  for (const glm::vec2 c : {glm::vec2(-6, -6), {6, -6}, {-6, 6}, {6, 6}})
    sheet.vertices.push_back({.position = {c.x, 0, c.y}, .normal = {0, 1, 0}});
  sheet.indices = {0, 2, 1, 1, 2, 3};
  set_tangents(sheet);
  scene->meshes.push_back(sheet);
  glm::dmat4 up(1);
  up[3] = glm::dvec4(18, 9, 14, 1);
  scene->instances.push_back({"sheet", static_cast<int>(scene->meshes.size()) - 1, 2, up});
  scene->bounds = bounds_of(*scene);
  s.scene = scene;
  const double both = *bench().measure(s).errors.shadow_lit_pixels;
  s.settings.shadow.cull = ShadowCull::front;
  EXPECT_GT(*bench().measure(s).errors.shadow_lit_pixels, both + 500) << "the sheet faces the light: it is not drawn";
}

}  // namespace
}  // namespace gbl::test
