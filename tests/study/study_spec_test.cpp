#include "renderer/study/study_spec.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

#include "renderer/base/json.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/presets.h"
#include "renderer/study/seeded_camera.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

DeviceLimits everything() {
  DeviceLimits limits;
  for (const FeatureRow& f : kFeatures) limits.features.add(f.feature);
  return limits;
}

// A scene without anything, by whatever name; what the looks of the built-in ones say is applied all the same.
std::shared_ptr<const Scene> empty_scene(const std::string& name) {
  auto scene = std::make_shared<Scene>();
  scene->name = name;
  scene->camera.position = {1, 2, 3};
  return scene;
}

StudySpec spec_of(const std::string& members) {
  return parse_study(fmt::format(R"({{"name": "n", {}}})", members), "study.json");
}
StudyPlan plan_of(const std::string& members) { return expand(spec_of(members), empty_scene, everything()); }
Settings one(const std::string& base) {
  const StudyPlan plan = plan_of(fmt::format(R"("base": {})", base));
  EXPECT_EQ(plan.cases.size(), 1u);
  return plan.cases.at(0).settings;
}
std::vector<std::string> ids(const StudyPlan& plan) {
  std::vector<std::string> list;
  for (const StudyCase& c : plan.cases) list.push_back(c.id);
  return list;
}

TEST(Expand, IsAProductWhoseLastPathIsTheFastest) {
  const StudyPlan plan = plan_of(R"("permute": {"normal.encoding": ["oct8", "oct16"], "lights": [4, 8]})");
  EXPECT_EQ(plan.study, "n");
  EXPECT_EQ(ids(plan), (std::vector<std::string>{"normal.encoding=oct8 lights=4", "normal.encoding=oct8 lights=8",
                                                 "normal.encoding=oct16 lights=4", "normal.encoding=oct16 lights=8"}));
  const StudyCase& last = plan.cases[3];
  EXPECT_EQ(last.settings.normal.encoding, NormalEncoding::oct16);
  EXPECT_EQ(last.settings.lights.count, 8);
  ASSERT_EQ(last.at.size(), 2u);
  EXPECT_EQ(last.at[1].path, "lights");
  EXPECT_TRUE(last.at[1].value == OptionValue(8));
}

TEST(Expand, AnArrayIsTheUnionInOrder) {
  const StudyPlan plan = plan_of(R"("permute": [{"lights": [4]}, {"layout": ["exact", "float32"]}])");
  EXPECT_EQ(ids(plan), (std::vector<std::string>{"lights=4", "layout=exact", "layout=float32"}));
}

TEST(Expand, WithoutPermuteTheBaseIsTheOneCase) {
  const StudyPlan plan = plan_of(R"("base": {"lights": 3})");
  EXPECT_EQ(ids(plan), std::vector<std::string>{"base"});
  EXPECT_EQ(plan.cases[0].settings.lights.count, 3);
}

TEST(Expand, AppliesInOneOrderWhateverTheFileSays) {
  const Settings s = one(R"({"attenuation": "quadratic", "lights": 5, "scene": "builtin:hall", "preset": "nclgl"})");
  EXPECT_EQ(s.layout, Layout::nclgl);                   // the preset's
  EXPECT_EQ(s.scene, "builtin:hall");                   // over the preset's
  EXPECT_EQ(s.camera.position, glm::dvec3(1, 2, 3));    // the scene's
  EXPECT_EQ(s.background.fill, BackgroundFill::black);  // its look
  EXPECT_EQ(s.lights.count, 5);                         // over the look's
  EXPECT_EQ(s.attenuation, Attenuation::quadratic);     // over the look's
}

TEST(Expand, ASceneBringsWhatItBringsOnTheCommandLine) {
  Settings expected;
  apply_scene(expected, "builtin:hall", *empty_scene("builtin:hall"));
  expected.size = {640, 360};
  EXPECT_EQ(one(R"({"scene": "builtin:hall"})"), expected);
  Settings plain;
  apply_scene(plain, plain.scene, *empty_scene(plain.scene));
  plain.size = {640, 360};
  EXPECT_EQ(one("{}"), plain) << "the default scene with its camera";
}

TEST(Expand, LightsAreGeneratedAndSizesAreTextOrNumbers) {
  EXPECT_EQ(one(R"({"preset": "stereo"})").lights.source, LightSource::scene);
  EXPECT_EQ(one(R"({"preset": "stereo", "lights": 7})").lights.source, LightSource::generated);
  EXPECT_EQ(one(R"({"preset": "learnopengl"})").size, glm::ivec2(640, 360)) << "not the preset's own";
  EXPECT_EQ(one(R"({"size": "320x200"})").size, glm::ivec2(320, 200));
  EXPECT_EQ(one(R"({"size": [320, 200]})").size, glm::ivec2(320, 200));
  EXPECT_EQ(ids(plan_of(R"("permute": {"size": [[32, 20], "64x40"]})")),
            (std::vector<std::string>{"size=32x20", "size=64x40"}));
}

TEST(Expand, ViewsAreNoPartOfACase) { EXPECT_EQ(one(R"({"preset": "start"})").view, Settings{}.view); }

TEST(Expand, SeededCamerasGoOverTheScenesOwn) {
  const auto spec = spec_of(R"("base": {"scene": "builtin:layers"}, "permute": {"camera.seed": [0, 1, 2]})");
  int opened = 0;
  const SceneFn open = [&](const std::string& name) { return ++opened, open_scene(name); };
  const StudyPlan plan = expand(spec, open, everything());
  ASSERT_EQ(plan.cases.size(), 3u);
  EXPECT_EQ(opened, 1) << "each scene once";
  const auto scene = open_scene("builtin:layers");
  EXPECT_EQ(plan.cases[0].settings.camera, scene->camera);
  EXPECT_EQ(plan.cases[2].settings.camera, seeded_camera(*scene, scene->camera, 2));
}

TEST(Expand, RulesLeaveCasesOut) {
  const StudyPlan plan = plan_of(R"("permute": {"lights.method": ["fullscreen", "quads"], "lights": [4, 8, 16]},
      "skip": [{"lights.method": "fullscreen", "lights": [8, 16]}, {"lights": 4, "preset": "start"}])");
  EXPECT_EQ(ids(plan), (std::vector<std::string>{"lights.method=fullscreen lights=4", "lights.method=quads lights=4",
                                                 "lights.method=quads lights=8", "lights.method=quads lights=16"}));
  ASSERT_EQ(plan.left_out.size(), 2u);
  EXPECT_EQ(plan.left_out[0].by, LeftOutBy::rule);
  EXPECT_EQ(plan.left_out[0].id, "lights.method=fullscreen lights=8");
}

TEST(Expand, RulesSeeTheBaseToo) {
  EXPECT_TRUE(plan_of(R"("base": {"layout": "exact"}, "permute": {"lights": [4, 8]}, "skip": [{"layout": "exact"}])")
                  .cases.empty());
}

TEST(Expand, CasesThatCannotBeDrawnAreLeftOutWithTheReason) {
  const auto spec = spec_of(R"("permute": {"lights.method": ["quads", "tiled"], "camera.far": [0.5, 100]})");
  DeviceLimits bare;
  const StudyPlan plan = expand(spec, empty_scene, bare);
  EXPECT_EQ(ids(plan), std::vector<std::string>{"lights.method=quads camera.far=100"});
  ASSERT_EQ(plan.left_out.size(), 3u);
  EXPECT_EQ(plan.left_out[0].by, LeftOutBy::invalid);
  EXPECT_TRUE(contains(plan.left_out[0].reason, "far-not-beyond-near")) << plan.left_out[0].reason;
  EXPECT_TRUE(contains(plan.left_out[2].reason, "compute")) << plan.left_out[2].reason;
}

TEST(Expand, WhatIsDrawnAlikeIsDrawnOnce) {
  const StudyPlan plan = plan_of(R"("permute": {"position.source": ["depth", "view32f"],
      "position.reconstruct": ["view-ray", "inverse-viewproj"]})");
  EXPECT_EQ(plan.cases.size(), 3u);
  ASSERT_EQ(plan.left_out.size(), 1u);
  EXPECT_EQ(plan.left_out[0].by, LeftOutBy::duplicate);
  EXPECT_TRUE(contains(plan.left_out[0].reason, "position.source=view32f position.reconstruct=view-ray"));
}

TEST(Expand, IsTheSameEveryTime) {
  const StudySpec spec = load_study("tradeoff");
  const StudyPlan a = expand(spec, empty_scene, everything()), b = expand(spec, empty_scene, everything());
  ASSERT_EQ(ids(a), ids(b));
  for (size_t i = 0; i < a.cases.size(); ++i) EXPECT_EQ(a.cases[i].settings, b.cases[i].settings);
}

// ---- bad files --------------------------------------------------------------------------------------------
void expect_refused(const std::string& members, std::initializer_list<const char*> parts) {
  const std::string line = error_line(ExitCode::bad_input, [&] { spec_of(members); });
  EXPECT_TRUE(line.starts_with("study.json")) << line;
  for (const char* part : parts) EXPECT_TRUE(contains(line, part)) << line << "\nmisses: " << part;
}

TEST(StudyFiles, MistakesNameTheFileThePathAndTheMend) {
  expect_refused(R"("permute": {"lights": [1, 2})", {"study.json:1:", "not valid JSON"});
  expect_refused(R"("permuted": {})", {"unknown member \"permuted\"", "did you mean 'permute'"});
  expect_refused(R"("version": 9)", {"version 9", "update the program"});
  expect_refused(R"("base": {"lights.cul": "back"})", {"base", "lights.cul", "did you mean 'lights.cull'"});
  expect_refused(R"("base": {"light": 3})", {"did you mean 'lights'"});
  expect_refused(R"("base": {"camera": {"fov": 3}})", {"camera", "unknown path"});
  expect_refused(R"("base": {"view.main": "normal"})", {"view.main", "leave it out"});
  expect_refused(R"("base": [])", {"base", "must be an object"});
  expect_refused(R"("base": {"size": "640"})", {"size", "640x360"});
  expect_refused(R"("base": {"preset": "strat"})", {"base: preset", "did you mean 'start'"});
  expect_refused(R"("base": {"camera.seed": -1})", {"camera.seed", "whole number"});
  expect_refused(R"("base": {"lights": 1.5})", {"lights.count", "whole number"});
  expect_refused(R"("permute": {"lights.cull": ["bakc"]})", {"permute: lights.cull", "did you mean 'back'"});
  expect_refused(R"("permute": {"lights": 4})", {"permute", "lights is 4", "[ ]"});
  expect_refused(R"("permute": {"lights": ["four"]})", {"permute", "lights.count", "number"});
  expect_refused(R"("permute": {"lights": [1], "layout": []})", {"layout has no values", "product is empty"});
  expect_refused(R"("permute": [])", {"permute", "empty"});
  expect_refused(R"("permute": [{"lights": [1]}, {}])", {"permute 2", "empty"});
  expect_refused(R"("skip": {"lights": 4})", {"skip", "array"});
  expect_refused(R"("skip": [{}])", {"skip 1", "every case"});
  expect_refused(R"("skip": [{"lights.cull": ["bakc"]}])", {"skip 1", "did you mean 'back'"});
  expect_refused(R"("x": "mibs")", {"x", "did you mean 'mib'"});
  expect_refused(R"("y": "rmse")", {"y", "rmse_linear"});
  expect_refused(R"("family": "normals")", {"normals", "unknown path"});
  expect_refused(R"("name": "")", {"\"name\" is missing or empty"});
}

TEST(StudyFiles, TooManyCasesAreRefusedBeforeTheyAreMade) {
  std::string values = "0";
  for (int i = 1; i < 400; ++i) values += fmt::format(", {}", i);
  expect_refused(fmt::format(R"("permute": {{"lights": [{0}], "lights.seed": [{0}], "time_s": [{0}], "ambient": [1],
      "lights.first": [{0}], "camera.seed": [{0}], "view": []}})",
                             values),
                 {"view"});
  expect_refused(fmt::format(R"("permute": {{"lights": [{0}], "lights.seed": [{0}], "time_s": [{0}],
      "lights.first": [{0}], "camera.seed": [{0}], "camera.far": [{1}]}})",
                             values, values.substr(3)),
                 {"more than 100000 cases"});
}

TEST(StudyFiles, AreFoundByNameOrAsAFile) {
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [] { load_study("normal"); }), "did you mean 'normals'"));
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [] { load_study("no/such.json"); }), "cannot be read"));
  const TemporaryFolder folder("study-spec");
  const std::string file = (folder / "mine.json").string();
  std::ofstream(file) << R"({"name": "mine", "permute": {"lights": [1, 2]}})";
  const StudySpec spec = load_study(file);
  EXPECT_EQ(spec.label, "mine");
  EXPECT_EQ(spec.x, "time_ms_total_median");
  EXPECT_EQ(spec.where, file);
}

// ---- the built-in ones ------------------------------------------------------------------------------------
struct Expected {
  const char* id;
  size_t fewest, most;
};
constexpr Expected kBuiltin[] = {{"accumulation", 40, 40}, {"forward-or-deferred", 60, 80},
                                 {"lights", 40, 56},       {"normals", 32, 32},
                                 {"parallax", 26, 26},     {"positions", 24, 40},
                                 {"presets", 15, 15},      {"quick", 15, 15},
                                 {"reflections", 17, 17},  {"shadows", 80, 100},
                                 {"tradeoff", 220, 300}};

TEST(BuiltinStudies, AreListedByTheNameOfTheirFile) {
  const std::vector<BuiltinStudy> list = builtin_studies();
  ASSERT_EQ(list.size(), std::size(kBuiltin));
  for (size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].id, kBuiltin[i].id);
    EXPECT_EQ(load_study(list[i].id).name, list[i].id);
    EXPECT_GT(list[i].label.size(), 10u);
  }
}

TEST(BuiltinStudies, ExpandToTheCasesTheyPromise) {
  for (const Expected& expected : kBuiltin) {
    const StudyPlan plan = expand(load_study(expected.id), empty_scene, everything());
    EXPECT_GE(plan.cases.size(), expected.fewest) << expected.id;
    EXPECT_LE(plan.cases.size(), expected.most) << expected.id;
    RecordProperty(expected.id, static_cast<int>(plan.cases.size()));
    std::set<std::string> seen;
    for (const StudyCase& c : plan.cases) {
      EXPECT_TRUE(validate(c.settings, everything()).empty()) << expected.id << " " << c.id;
      EXPECT_EQ(c.settings.size, glm::ivec2(640, 360));
      EXPECT_TRUE(seen.insert(c.id).second) << expected.id << " " << c.id;
    }
    for (const LeftOut& l : plan.left_out)
      EXPECT_NE(l.by, LeftOutBy::invalid) << expected.id << " " << l.id << ": " << l.reason;
  }
}

// Points that stand for different pictures would not belong on one chart.
TEST(BuiltinStudies, TheTradeoffHasOneTruthAndEveryPreset) {
  const StudyPlan plan = expand(load_study("tradeoff"), empty_scene, everything());
  std::set<std::string> presets_seen;
  for (const StudyCase& c : plan.cases) {
    EXPECT_TRUE(same_truth(c.settings, plan.cases[0].settings)) << c.id;
    if (c.at[0].path == "preset") presets_seen.insert(std::get<std::string>(c.at[0].value));
  }
  EXPECT_EQ(presets_seen.size(), presets().size());
  EXPECT_EQ(plan.cases[1].settings.layout, Layout::nclgl);
  EXPECT_EQ(plan.cases[1].settings.mistakes, preset("nclgl").make().mistakes);
  EXPECT_EQ(expand(load_study("presets"), empty_scene, everything()).cases.size(), presets().size());
}

constexpr const char* kOwnSpec = R"({"version": 1, "name": "own",
  "base": {"scene": "builtin:room", "camera.fov": 30, "exposure": 2, "lights": 16, "ambient": 0.1},
  "permute": {"normal.encoding": ["oct8", "oct16"]}})";

TEST(GivenToAStudy, StandsInThePlaceOfItsBase) {
  const StudySpec spec = parse_study(kOwnSpec, "own.json");
  const StudyPlan before = expand(spec, empty_scene, everything());
  const StudyPlan after =
      expand(with_given(spec, {}, {{"scene", "builtin:hall"}, {"ambient", 0.4}, {"size", "320x180"}, {"lights", 64}}),
             empty_scene, everything());
  ASSERT_EQ(after.cases.size(), before.cases.size());
  for (size_t i = 0; i < after.cases.size(); ++i) {
    const Settings& s = after.cases[i].settings;
    EXPECT_EQ(after.cases[i].id, before.cases[i].id) << "what varies stays";
    EXPECT_EQ(s.scene, "builtin:hall");
    EXPECT_EQ(s.ambient, 0.4);
    EXPECT_EQ(s.size, glm::ivec2(320, 180));
    EXPECT_EQ(s.lights.count, 64);
    EXPECT_NE(s.camera.fov, 30) << "a scene brings its own camera";
    EXPECT_EQ(before.cases[i].settings.camera.fov, 30);
  }
  const StudySpec given = with_given(spec, {}, {{"ambient", 0.4}});
  EXPECT_EQ((*given.json)["base"]["ambient"], 0.4) << "the files say what was measured";
  EXPECT_EQ((*given.json)["base"]["scene"], "builtin:room");
  EXPECT_EQ(parse_study(given.json->dump(), "again").base, given.base);
  const StudyPlan aimed =
      expand(with_given(spec, {}, {{"scene", "builtin:hall"}, {"camera.fov", 50}}), empty_scene, everything());
  EXPECT_EQ(aimed.cases[0].settings.camera.fov, 50) << "unless one is given";
}

TEST(GivenToAStudy, IsRefusedWhereTheStudyVariesIt) {
  const StudySpec spec = parse_study(kOwnSpec, "own.json");
  try {
    with_given(spec, {}, {{"normal.encoding", "xyz8"}});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    EXPECT_NE(std::string(e.what()).find("is what the study 'own' varies"), std::string::npos) << e.what();
  }
  // A state says everything: what varies is passed over, the rest counts.
  const StudyPlan plan =
      expand(with_given(spec, {{"normal.encoding", "xyz8"}, {"ambient", 0.3}}, {}), empty_scene, everything());
  ASSERT_EQ(plan.cases.size(), 2u);
  EXPECT_EQ(plan.cases[0].settings.normal.encoding, NormalEncoding::oct8);
  EXPECT_EQ(plan.cases[0].settings.ambient, 0.3);
  // Where whole presets vary it has no say in how to draw.
  const StudyPlan presets = expand(with_given(load_study("quick"), {{"ambient", 0.3}, {"normal.encoding", "oct8"}}, {}),
                                   empty_scene, everything());
  EXPECT_EQ(presets.cases.size(), expand(load_study("quick"), empty_scene, everything()).cases.size());
  for (const StudyCase& c : presets.cases) EXPECT_EQ(c.settings.ambient, 0.3) << c.id;
  EXPECT_THROW(with_given(spec, {}, {{"view.main", "depth"}}), Error) << "a study looks at nothing";
}

}  // namespace
}  // namespace gbl
