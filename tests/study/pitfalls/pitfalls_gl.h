#pragma once
// One test per entry of the catalogue, at a size.
#include "app/pitfall_bench.h"
#include "renderer/study/pitfalls/judge.h"
#include "tests/gl_fixture.h"

namespace gbl::test {

class EveryPitfall : public GlTest, public testing::WithParamInterface<std::string> {
 protected:
  void expect_as_catalogued(glm::ivec2 size) {
    Renderer renderer;
    PitfallBench bench(renderer, gl::probe_device({}));
    const auto measure = [&](const Settings& drawn, const Settings& meant) { return bench.measure(drawn, meant); };
    const PitfallResult r = judge_pitfall(load_pitfall(GetParam()), size, bench.limits(), bench.rounding(), measure);
    if (!r.skipped.empty()) GTEST_SKIP() << r.skipped;
    EXPECT_TRUE(r.holds()) << r.wrong;
  }
};

inline std::vector<std::string> pitfall_ids() {
  std::vector<std::string> out;
  for (const PitfallEntry& e : load_pitfalls()) out.push_back(e.id);
  return out;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace gbl::test
