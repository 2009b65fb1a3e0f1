// The whole way on another driver, Mesa's plain rasteriser softpipe: it restarts its numbering of triangles within a
// draw, lacks much of what llvmpipe has, and rounds otherwise. A program of its own, so that the driver is chosen
// before the context is made.
#include <cstdlib>

#include "app/bench.h"
#include "app/truth_keeper.h"
#include "renderer/frame/validate.h"
#include "renderer/opening/scene_look.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

const int kChosen = setenv("GALLIUM_DRIVER", "softpipe", 1);

struct PresetCase {
  std::string id;
};
void PrintTo(const PresetCase& c, std::ostream* out) { *out << c.id; }

std::vector<PresetCase> all_presets() {
  std::vector<PresetCase> out;
  for (const Preset& p : presets()) out.push_back({p.id});
  return out;
}
std::string name_of(const ::testing::TestParamInfo<PresetCase>& info) {
  std::string name = info.param.id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class Softpipe : public GlTest, public ::testing::WithParamInterface<PresetCase> {
 protected:
  void SetUp() override {
    ASSERT_EQ(kChosen, 0);
    GlTest::SetUp();
    if (gl::device().renderer.find("softpipe") == std::string::npos)
      GTEST_SKIP() << "this driver has no softpipe: " << gl::device().renderer;
  }
};
INSTANTIATE_TEST_SUITE_P(EveryPreset, Softpipe, ::testing::ValuesIn(all_presets()), name_of);

double largest(const glm::dvec3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

// The float32 forward frame is the truth but for float's noise: the reference took no wrong triangle from the driver.
TEST_P(Softpipe, TheReferenceHolds) {
  Settings s = preset(GetParam().id).make();
  s.size = {32, 18};
  s.reflect.size = ReflectSize::s64;  // and small maps: of the usual size they would take this driver a minute
  s.shadow.map_size = ShadowMapSize::s256;
  const GpuScene scene(open_scene(s.scene));
  if (!validate(s, {gl::device().features, gl::device().max_size, gl::device().max_draw_buffers}).empty())
    GTEST_SKIP() << "this driver cannot draw the preset";
  Renderer renderer;
  TruthKeeper keeper(1, 2);
  const std::shared_ptr<const TruthSet> set = keeper.get(renderer, scene, lit_alone(s), true);
  size_t off = 0;
  for (size_t i = 0; i < set->truth.pixels(); ++i)
    off += largest(glm::dvec3(set->witness_lit[i]) - set->truth.lit[i]) > 1e-3 * (1 + largest(set->truth.lit[i]));
  // Silhouettes and normals bent within one pixel: 3 of 576 at most were measured, whatever the driver.
  EXPECT_LE(off, 6u) << set->triangles_replaced << " triangles were looked up";
  Targets targets;
  EXPECT_NO_THROW(renderer.render(s, scene, targets));
}

// Without the look-up it would not: this is what the test above guards.
TEST_F(Softpipe, NamesWrongTrianglesInLongDraws) {
  Settings s = preset("start").make();
  s.size = {32, 18};
  const GpuScene scene(open_scene(s.scene));
  Renderer renderer;
  TruthKeeper keeper(1, 2);
  const size_t replaced = keeper.get(renderer, scene, s, true)->triangles_replaced;
  if (replaced == 0) GTEST_SKIP() << "this version of softpipe numbers its triangles right";
  EXPECT_GT(replaced, 10u);
}

}  // namespace
}  // namespace gbl::test
