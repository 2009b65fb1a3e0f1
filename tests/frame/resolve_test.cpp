#include "renderer/frame/resolve.h"

#include <gtest/gtest.h>
#include <utility>

#include "renderer/frame/attachments.h"

namespace gbl {
namespace {

Scene with(Material m) {
  Scene s;
  s.materials.push_back(std::move(m));
  s.instances = {{"thing", 0, 0, glm::dmat4(1)}};
  return s;
}

TEST(NeedsOf, LooksAtWhatIsUsedAndOpaque) {
  EXPECT_FALSE(needs_of(with({.name = "plain"})).any());
  EXPECT_TRUE(needs_of(with({.metal = 1})).metal);
  EXPECT_TRUE(needs_of(with({.emissive = {0, 0.1f, 0}})).emission);
  EXPECT_TRUE(needs_of(with({.unlit = true})).emission);
  EXPECT_FALSE(needs_of(with({.metal = 1, .alpha_mode = AlphaMode::blend})).any());
  Scene unused = with({.name = "plain"});
  unused.materials.push_back({.metal = 1});
  EXPECT_FALSE(needs_of(unused).any());
  Material occluded;
  occluded.occlusion_texture.texture = 0;
  EXPECT_TRUE(needs_of(with(occluded)).occlusion);
  EXPECT_TRUE(needs_of(with({.refraction_index = 1.33f})).specular);
  EXPECT_TRUE(needs_of(with({.specular = 0.5f})).specular);
  EXPECT_FALSE(needs_of(with({.specular = 0.5f, .unlit = true})).specular) << "it reflects nothing";
}

TEST(Resolve, AutoTakesTheSmallestLayoutThatHoldsTheMaterials) {
  Settings s;
  s.layout = Layout::auto_;
  EXPECT_EQ(resolve(s, with({})).settings.layout, Layout::albedo_roughness);
  for (const Material& m : {Material{.metal = 1}, Material{.emissive = glm::vec3(1)}}) {
    const Resolved r = resolve(s, with(m));
    EXPECT_EQ(r.settings.layout, Layout::compact_metal);
    EXPECT_GE(r.notes.size(), 2u) << "what is left out is said";
  }
}

TEST(Resolve, AReflectanceOfItsOwnIsKeptByAutoAndByTheLabsOwnLayouts) {
  for (const Layout l :
       {Layout::auto_, Layout::compact, Layout::compact_metal, Layout::exact, Layout::exact_emission}) {
    Settings s;
    s.layout = l;
    const Resolved r = resolve(s, with({.metal = 0.5f, .emissive = glm::vec3(1), .specular_colour = {1, 0.5f, 0}}));
    EXPECT_EQ(r.settings.layout, Layout::exact_specular) << row(l).id;
    EXPECT_FALSE(r.notes.empty());
  }
}

TEST(Resolve, CompactTakesAWordMoreOnlyWhereItMust) {
  Settings s;
  s.layout = Layout::compact;
  s.normal.encoding = NormalEncoding::oct14;
  const Settings plain = resolve(s, with({})).settings, metal = resolve(s, with({.metal = 1})).settings;
  EXPECT_EQ(gbuffer_bytes_per_pixel(plain), 12);
  EXPECT_EQ(gbuffer_bytes_per_pixel(metal), 16);
}

TEST(Resolve, LeavesEveryOtherSettingAlone) {
  for (const ValueRow& r : rows<Layout>()) {
    Settings s;
    s.layout = static_cast<Layout>(r.value);
    const Resolved done = resolve(s, with({.metal = 1}));
    Settings back = done.settings;
    EXPECT_NE(back.layout, Layout::auto_);
    EXPECT_EQ(done.notes.empty(), back.layout == s.layout);
    EXPECT_EQ(resolve(back, with({.metal = 1})).settings, back) << "resolved is resolved";
    back.layout = s.layout;
    EXPECT_EQ(back, s);
  }
}

}  // namespace
}  // namespace gbl
