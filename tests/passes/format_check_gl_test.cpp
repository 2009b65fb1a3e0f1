// What the lab asks of a GPU before it believes it.
#include "renderer/passes/format_check.h"

#include <set>

#include "renderer/options/options.h"
#include "tests/gl_fixture.h"
#include "tests/shader_copy.h"

namespace gbl::test {
namespace {

class FormatChecks : public GlTest {
 protected:
  FormatCheck check(StoredAs s) { return check_format(s, gl::probe_rounding()); }
};

TEST_F(FormatChecks, EveryFormatHoldsHere) {
  for (const StoredAs s : all_stored(gl::device().features)) {
    const FormatCheck c = check(s);
    EXPECT_TRUE(c.holds()) << c.said();
    EXPECT_GE(c.error, 0) << c.said();
  }
}

TEST_F(FormatChecks, EveryRowOfTheThreeAxesIsAsked) {
  std::set<std::string> names;
  FeatureSet all;
  all.add(Feature::clip_control);
  for (const StoredAs s : all_stored(all)) names.insert(name_of(s));
  for (const char* path : {"normal.encoding", "depth.format", "accumulation.format"})
    for (const ValueRow& r : option(path).values)
      EXPECT_EQ(names.count(fmt::format("{}={}", path, r.id)), std::string(r.id) == "auto" ? 0u : 1u) << r.id;
  for (const StoredAs s : all_stored({})) EXPECT_NE(name_of(s), "depth.format=d32f-reversed") << "needs clip control";
}

// A driver that decodes otherwise, made of the shaders' own text: only what it breaks is off.
TEST_F(FormatChecks, AnotherAnswerIsSeenAndNamed) {
  ShaderCopy copy;
  struct Case {
    const char *file, *mark, *line;
    StoredAs broken, whole;
  };
  const Case cases[] = {
      {"shaders/normal_texel.glsl", "  return world_from_stored(DECODE_NORMAL(code_from_texel(stored)));",
       "  return DECODE_NORMAL(code_from_texel(stored)).yxz;", NormalEncoding::oct16, DepthFormat::d24},
      {"shaders/depth.glsl", "  // near far / (far - depth",
       "  return planes.z / (planes.x + depth_from_far(depth) * planes.y);", DepthFormat::d24,
       AccumulationFormat::rgba16f},
  };
  for (const Case& c : cases) {
    copy.insert(c.file, c.mark, c.line);
    const FormatCheck broken = check(c.broken);
    EXPECT_FALSE(broken.holds()) << broken.said();
    EXPECT_NE(broken.said().find(name_of(c.broken)), std::string::npos) << broken.said();
    EXPECT_TRUE(check(c.whole).holds()) << check(c.whole).said();
    copy.restore(c.file);
    EXPECT_TRUE(check(c.broken).holds());
  }
}

TEST_F(FormatChecks, NumbersThatAreNoneDoNotHold) {
  ShaderCopy copy;
  copy.insert("shaders/depth.glsl", "  // near far / (far - depth", "  return sqrt(-1.0 - depth);");
  EXPECT_FALSE(check(DepthFormat::d32f).holds());
}

}  // namespace
}  // namespace gbl::test
