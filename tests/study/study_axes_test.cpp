#include "renderer/study/study_axes.h"

#include <gtest/gtest.h>

#include "renderer/opening/scene_look.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

StudyPlan plan_of(std::string_view axes) {
  DeviceLimits limits;
  for (const FeatureRow& f : kFeatures) limits.features.add(f.feature);
  return expand(
      study_of_axes(axes), [](const std::string& name) { return open_scene(name); }, limits);
}

TEST(StudyAxes, EveryValueAloneComesFirstThenPairsThenTheRest) {
  const StudyPlan plan = plan_of("depth.format,accumulation.format,accumulation.targets");
  size_t most = 1;
  std::set<std::string> alone, keys;
  for (const StudyCase& c : plan.cases) {
    EXPECT_GE(c.at.size(), most) << c.id;
    most = std::max(most, c.at.size());
    if (c.at.size() == 1) alone.insert(c.id);
    EXPECT_TRUE(keys.insert(c.id).second) << c.id << " stands twice";
  }
  EXPECT_EQ(most, 3u);
  for (const char* id : {"depth.format=d16", "accumulation.format=rgba8"}) EXPECT_TRUE(alone.count(id)) << id;
  size_t product = 1;
  for (const char* path : {"depth.format", "accumulation.format", "accumulation.targets"})
    product *= option(path).values.size();
  EXPECT_EQ(plan.cases.size(), product) << "the whole product in the end: what is drawn alike is measured once";
}

TEST(StudyAxes, OneAxisIsItsValues) { EXPECT_EQ(plan_of("accumulation.format").cases.size(), 4u); }

TEST(StudyAxes, AWrongNameIsAnsweredWithTheNearest) {
  const auto refused = [](const char* axes) { return error_line(ExitCode::bad_input, [&] { study_of_axes(axes); }); };
  EXPECT_TRUE(contains(refused("normal.encodng"), "normal.encoding"));
  EXPECT_TRUE(contains(refused("lights.count"), "no list of values"));
  EXPECT_TRUE(contains(refused("view.main"), "leave it out"));
  EXPECT_TRUE(contains(refused("layout,layout"), "twice"));
  EXPECT_TRUE(contains(refused(""), "names no option"));
  EXPECT_TRUE(contains(refused("layout,normal.encoding,lights.method,position.source,depth.format,accumulation.format"),
                       "cases"));
}

TEST(ParseDuration, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parse_duration("90s", "--budget"), 90);
  EXPECT_EQ(parse_duration("10m", "--budget"), 600);
  EXPECT_EQ(parse_duration("1.5h", "--budget"), 5400);
  EXPECT_EQ(parse_duration("1h30m", "--budget"), 5400);
  for (const char* bad : {"", "10", "m", "-5m", "0s", "10x", "10m5", "1e400s"})
    EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { parse_duration(bad, "--budget"); }), "--budget")) << bad;
}

}  // namespace
}  // namespace gbl
