#include "renderer/options/axes.h"

#include <fstream>
#include <functional>
#include <regex>
#include <set>

#include "renderer/options/options.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

const std::regex kKebab("[a-z0-9]+(-[a-z0-9]+)*");

void for_each_axis(const std::function<void(const Option&)>& check) {
  for (const Option& o : options())
    if (o.kind == Kind::choice) {
      SCOPED_TRACE(o.path);
      check(o);
    }
}

TEST(Axes, EveryEnumOfTheHeaderIsReachedByAnOption) {
  int enums = 3;  // Layout, NormalEncoding and LightMethod: their rows hold more and stand in files of their own
  for (const char* file : {"options/axes.h", "gbuffer/gbuffer_axes.h", "light/light_axes.h"}) {
    std::ifstream header(test::source_folder() / "renderer" / file);
    EXPECT_TRUE(header) << file;
    for (std::string line; std::getline(header, line);) enums += line.rfind("enum class ", 0) == 0;
  }
  std::set<const ValueRow*> tables;
  for_each_axis([&](const Option& o) { tables.insert(o.values.data()); });
  EXPECT_GT(enums, 20);
  EXPECT_EQ(static_cast<int>(tables.size()), enums);
}

TEST(Axes, IdsAreUniqueKebabCaseAndReadBack) {
  for_each_axis([](const Option& o) {
    ASSERT_FALSE(o.values.empty());
    std::set<std::string> ids, labels;
    for (size_t i = 0; i < o.values.size(); ++i) {
      const ValueRow& r = o.values[i];
      EXPECT_EQ(r.value, static_cast<int>(i));
      EXPECT_TRUE(std::regex_match(r.id, kKebab)) << r.id;
      EXPECT_TRUE(ids.insert(r.id).second) << r.id;
      EXPECT_TRUE(labels.insert(r.label).second) << r.label;
      EXPECT_EQ(parse_id(o.values, r.id, o.path), static_cast<int>(i));
    }
  });
}

TEST(Axes, EveryRowHasALabelAndOneLineOfHelp) {
  for_each_axis([](const Option& o) {
    for (const ValueRow& r : o.values) {
      EXPECT_STRNE(r.label, "") << r.id;
      EXPECT_STRNE(r.help, "") << r.id;
      for (const char* text : {r.label, r.help, r.cost, r.source}) EXPECT_FALSE(contains(text, "\n")) << r.id;
    }
  });
}

TEST(Axes, PitfallsHaveTheCataloguesFormAndEachAxisHasAWayWithout) {
  for_each_axis([](const Option& o) {
    bool sound = false, needs_nothing = false;
    for (const ValueRow& r : o.values) {
      EXPECT_EQ(r.sound(), r.pitfall == Pitfall::none) << r.id;
      EXPECT_TRUE(r.sound() || std::regex_match(id_of(r.pitfall), kKebab)) << id_of(r.pitfall);
      EXPECT_TRUE(o.group == Group::method || r.sound()) << r.id << ": only a way to draw can be unsound";
      sound |= r.sound();
      needs_nothing |= r.needs == Feature::none;
    }
    EXPECT_TRUE(sound);
    EXPECT_TRUE(needs_nothing);  // cycle() would never end
  });
}

TEST(Axes, UnknownIdListsAllAndSuggestsTheNearest) {
  for_each_axis([](const Option& o) {
    for (const ValueRow& r : o.values) {
      const std::string typo = std::string(r.id) + "x";  // one letter away from this row, further from all others
      const std::string line = error_line(ExitCode::bad_input, [&] { parse_id(o.values, typo, "here"); });
      EXPECT_EQ(line.rfind("here: ", 0), 0u) << line;
      EXPECT_TRUE(contains(line, "'" + typo + "'")) << line;
      EXPECT_TRUE(contains(line, std::string("did you mean '") + r.id + "'?")) << line;
      for (const ValueRow& other : o.values) EXPECT_TRUE(contains(line, other.id)) << line;
    }
    const std::string line =
        error_line(ExitCode::bad_input, [&] { parse_id(o.values, "zzzzzzzzzzzzzzzzzzzz", "here"); });
    EXPECT_FALSE(contains(line, "did you mean")) << line;
    EXPECT_TRUE(contains(line, o.values.front().id)) << line;
  });
}

TEST(Axes, IdsAreCaseSensitiveAndNeverGuessed) {
  for (const char* id : {"", "Back", "BACK", "bac", "back ", " back"})
    EXPECT_THROW(parse_id(rows<LightCull>(), id, "lights.cull"), Error) << id;
}

TEST(Options, PathsAndKeysAreUniqueAndRowsFilledIn) {
  const std::regex path("[a-z0-9_-]+(\\.[a-z0-9-]+)*");
  std::set<std::string> paths, keys;
  for (const Option& o : options()) {
    EXPECT_TRUE(std::regex_match(o.path, path)) << o.path;
    EXPECT_TRUE(paths.insert(o.path).second) << o.path;
    EXPECT_TRUE(*o.key == '\0' || keys.insert(o.key).second) << o.path << " shares key " << o.key;
    EXPECT_STRNE(o.label, "") << o.path;
    EXPECT_STRNE(o.help, "") << o.path;
    EXPECT_EQ(o.kind == Kind::choice, !o.values.empty()) << o.path;
    const bool ranged = o.kind == Kind::integer || o.kind == Kind::number || o.kind == Kind::vector;
    EXPECT_EQ(ranged, o.min < o.max) << o.path;
    EXPECT_EQ(&option(o.path), &o);
    EXPECT_STRNE(std::string(group_id(o.group)).c_str(), "");
  }
}

TEST(Options, NoPathIsTheBeginningOfAnotherAtADot) {
  for (const Option& a : options())
    for (const Option& b : options())
      EXPECT_NE(std::string(b.path).rfind(std::string(a.path) + ".", 0), 0u) << a.path << " and " << b.path;
}

TEST(Options, UnknownPathSuggestsTheNearest) {
  const std::string line = error_line(ExitCode::bad_input, [] { option("lights.cul"); });
  EXPECT_TRUE(contains(line, "lights.cul: unknown option")) << line;
  EXPECT_TRUE(contains(line, "did you mean 'lights.cull'?")) << line;
}

TEST(Features, ListIsParsedAndUnknownOnesAreNamed) {
  const FeatureSet set = parse_features("compute,clip-control");
  for (const FeatureRow& r : kFeatures)
    EXPECT_EQ(set.has(r.feature), r.feature == Feature::compute || r.feature == Feature::clip_control) << r.id;
  EXPECT_TRUE(FeatureSet().has(Feature::none));
  for (const FeatureRow& r : kFeatures) {
    EXPECT_FALSE(parse_features("").has(r.feature));
    FeatureSet one = parse_features(r.id);
    EXPECT_TRUE(one.has(r.feature)) << r.id;
    one.remove(r.feature);
    EXPECT_FALSE(one.has(r.feature)) << r.id;
    EXPECT_EQ(static_cast<int>(r.feature), static_cast<int>(&r - kFeatures) + 1) << r.id;
  }
  const std::string line = error_line(ExitCode::bad_input, [] { parse_features("compute,depthclamp"); });
  EXPECT_TRUE(contains(line, "did you mean 'depth-clamp'?")) << line;
}

}  // namespace
}  // namespace gbl
