// Point, spot and directional lights together: every method draws what the plain loop draws.
#include <set>

#include "app/lab.h"
#include "renderer/opening/scene_look.h"
#include "tests/gl_fixture.h"

namespace gbl {
namespace {

class LightKinds : public test::GlTest {};

// The scene with its own seven lights, drawn soundly.
Settings spheres(Lab& lab) {
  Settings s = preset("start").make();
  s.size = {160, 90};
  lab.open("builtin:spheres");
  apply_scene(s, "builtin:spheres", lab.scene());
  s.lights.cull = LightCull::front;
  s.lights.volume.clip = VolumeClip::none;
  return s;
}

std::vector<float> lit_of(Lab& lab, const Settings& s) {
  lab.draw(s);
  return gl::read_rgba32f(*lab.targets().frame.texture(Stores::lit));
}

TEST_F(LightKinds, EveryMethodEqualsThePlainLoop) {
  Lab lab({});
  Settings s = spheres(lab);
  s.accumulation.format = AccumulationFormat::rgba32f;
  s.lights.method = LightMethod::fullscreen;
  const std::vector<float> expected = lit_of(lab, s);
  std::set<LightKind> kinds;
  for (const Light& l : lab.lights()) kinds.insert(l.kind);
  ASSERT_EQ(kinds.size(), 3u) << "the scene must hold all three kinds";
  test::for_each_row<LightMethod>([&](LightMethod method, const ValueRow& r) {
    s.lights.method = method;
    if (!sound(s) || shading_of(method) != Shading::deferred) return;  // others store other bits
    const std::vector<float> got = lit_of(lab, s);
    float worst = 0;
    for (size_t i = 0; i < got.size(); ++i) worst = std::max(worst, std::abs(got[i] - expected[i]));
    EXPECT_LE(worst, 2e-6f) << r.id << ": seven float terms in another order, radiances up to about 1";
  });
}

TEST_F(LightKinds, ADirectionalLightLightsAndASpotEndsAtItsCone) {
  Lab lab({});
  Settings s = spheres(lab);
  const std::vector<Light> lights = lab.scene().lights;
  for (size_t i = 0; i < lights.size(); ++i) {
    s.lights.only = static_cast<int>(i);
    lab.draw(s);
    lab.count_pairs(true);
    lab.collect(true);
    const PairCounts pairs = lab.report().pairs.value();
    EXPECT_GT(*pairs.lit, 0u) << i;
    EXPECT_GE(pairs.shaded, *pairs.lit) << i << ": a volume holds its light";
    if (lights[i].kind == LightKind::spot) {
      EXPECT_GT(pairs.shaded, *pairs.lit) << i << ": a cone is part of its sphere";
    }
    if (lights[i].kind == LightKind::directional) {
      EXPECT_EQ(pairs.shaded, *pairs.lit) << i << ": every surface";
    }
  }
}

}  // namespace
}  // namespace gbl
