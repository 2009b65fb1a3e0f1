// A layout is a row and a file: nothing else knows it.
#include "renderer/gbuffer/layouts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

#include "renderer/base/resources.h"

namespace gbl {
namespace {

TEST(Layouts, EachHasAFileThatPacksAndUnpacksAndEachFileHasItsRow) {
  std::set<std::string> files;
  files.insert(fmt::format("shaders/{}", kThinLayoutShader));
  for (const ValueRow& r : rows<Layout>())
    if (static_cast<Layout>(r.value) != Layout::auto_)
      files.insert("shaders/" + shader_of(static_cast<Layout>(r.value)));
  const std::vector<std::string> there = resource_names("shaders/layouts/");
  EXPECT_EQ(std::set<std::string>(there.begin(), there.end()), files);
  for (const std::string& file : there)
    for (const char* function : {"Stored pack_material(Surface s)", "void unpack_material(Stored t, inout Surface s)"})
      EXPECT_NE(resource(file).find(function), std::string::npos) << file << ": no " << function;
}

TEST(Layouts, ASuccessorKeepsWhatTheOtherLeavesOut) {
  for (const ValueRow& r : rows<Layout>()) {
    const LayoutRow& known = facts(static_cast<Layout>(r.value));
    for (const Successor& next : known.successors) {
      if (next.when == MaterialHas::nothing) continue;
      EXPECT_TRUE(facts(next.layout).keeps_emission) << r.id;
      EXPECT_TRUE(succeeds_another(next.layout)) << r.id;
      for (const Successor& further : facts(next.layout).successors)
        if (further.when != MaterialHas::nothing) {
          EXPECT_EQ(further.when, known.successors[0].when) << r.id << ": asked before, so that one step is enough";
        }
    }
  }
}

}  // namespace
}  // namespace gbl
