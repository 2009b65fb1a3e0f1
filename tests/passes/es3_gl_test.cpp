// OpenGL ES 3.0, which browsers have as WebGL 2, draws what OpenGL 3.3 draws: on llvmpipe to the last bit.
#include <fmt/format.h>

#include "renderer/opening/scene_look.h"
#include "renderer/options/settings_json.h"
#include "tests/faults/new_context.h"

namespace gbl::test {
namespace {

double largest_difference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  float most = 0;
  for (size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 4; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
  return double(most);
}

// A plane that clips makes corners of its own, and what lies between them is rounded otherwise; GLES discards pixels instead. Some
// thousand ulps of what a mirror shows, and far below a code of 255.
double allowed(const Settings& s) { return s.reflections == Reflections::on ? 2e-4 : 0; }

void expect_the_same_in_es3(const Settings& s, const std::string& what) {
  const Drawn core = drawn_on_a_new_context(s, 0), es3 = drawn_on_a_new_context(s, 0, gl::Api::es3);
  EXPECT_TRUE(es3.first == core.first) << what;
  ASSERT_EQ(es3.second.size(), core.second.size());
  EXPECT_LE(largest_difference(es3.second, core.second), allowed(s)) << what;
}

class Es3Presets : public testing::TestWithParam<std::string> {};

TEST_P(Es3Presets, GiveTheBitsOfCore) {
  Settings s = preset(GetParam()).make();
  s.size = {96, 54};
  expect_the_same_in_es3(s, GetParam());
}

std::vector<std::string> names_of_presets() {
  std::vector<std::string> out;
  for (const Preset& p : presets()) out.emplace_back(p.id);
  return out;
}
INSTANTIATE_TEST_SUITE_P(All, Es3Presets, testing::ValuesIn(names_of_presets()), [](const auto& of) {
  std::string name = of.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// What presets leave out, and what GLES does in another way: each light method, planes that mirror, maps of shadows, a table of
// many rows, samples, stored depths that are read.
TEST(Es3, WhateverElseIsDrawnGivesTheBitsOfCore) {
  std::vector<std::string> patches;
  for (const ValueRow& r : rows<LightMethod>())
    if (r.needs == Feature::none && r.value != static_cast<int>(LightMethod::auto_))
      patches.push_back(fmt::format(R"({{"lights.method": "{}"}})", r.id));
  for (const char* patch :
       {R"({"reflections": "on", "reflect.method": "planar", "shadows": "all"})",
        R"({"reflections": "on", "reflect.method": "cube"})", R"({"antialias": "msaa-resolved"})",
        R"({"lights.count": 3000, "lights.source": "generated", "lights.method": "clustered"})",
        R"({"position.source": "depth", "depth.format": "d24", "lights.volume.depth": "greater-equal",
                                "lights.cull": "front", "lights.method": "volumes"})"})
    patches.emplace_back(patch);
  for (const std::string& patch : patches) {
    Settings s = preset("exact").make();
    s.accumulation.targets = AccumulationTargets::split;
    apply_scene(s, "builtin:room", *open_scene("builtin:room"));
    apply_patch(s, parse_patch(patch, "patch"), "patch");
    s.size = {96, 54};
    expect_the_same_in_es3(s, patch);
  }
}

}  // namespace
}  // namespace gbl::test
