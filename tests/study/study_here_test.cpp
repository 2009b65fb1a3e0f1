// Studies moved to the scene and the truth at hand.
#include "renderer/study/study_here.h"

#include <gtest/gtest.h>
#include <set>

#include "renderer/scenes/builtin_scenes.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kSize{320, 180};

Settings settings_now() {
  Settings s;
  s.scene = "builtin:spheres";
  s.camera.position = {1, 2, 3};
  s.camera.near = 0.25;
  s.lights.count = 7, s.lights.seed = 5, s.lights.range_scale = 1.5;
  s.attenuation = Attenuation::quadratic;
  s.exposure = 1.25, s.time_s = 0.5;
  s.mistakes = {Mistake::tbn_precedence};
  return s;
}

StudyPlan plan_here(const std::string& id, const Settings& now) {
  const auto scene = std::make_shared<const Scene>(load_scene("builtin:spheres"));
  return expand(study_here(load_study(id), now, kSize), [&](const std::string&) { return scene; }, {});
}

TEST(StudyHere, CasesHaveTheTruthAtHandAndTheMethodsOfTheStudy) {
  const Settings now = settings_now();
  const StudyPlan plan = plan_here("normals", now);
  std::set<NormalEncoding> encodings;
  ASSERT_GE(plan.cases.size(), 16u);
  for (const StudyCase& c : plan.cases) {
    EXPECT_TRUE(same_truth_but(c.settings, now, {})) << c.id;
    EXPECT_EQ(c.settings.camera, now.camera) << "to the bit";
    EXPECT_EQ(c.settings.size, kSize);
    EXPECT_EQ(c.settings.layout, Layout::albedo_roughness);
    EXPECT_EQ(c.settings.lights.method, LightMethod::fullscreen_radius);
    EXPECT_TRUE(c.settings.mistakes.empty()) << "a mistake is a method: the study has none";
    encodings.insert(c.settings.normal.encoding);
  }
  EXPECT_EQ(encodings.size(), 16u);
}

TEST(StudyHere, TruthThatTheStudyVariesIsItsOwn) {
  Settings now = settings_now();
  now.lights.source = LightSource::scene;
  const std::vector<std::string> varied = varied_truth(load_study("lights"));
  EXPECT_EQ(varied, (std::vector<std::string>{"lights.count", "lights.source"}));
  std::set<int> counts;
  for (const StudyCase& c : plan_here("lights", now).cases) {
    counts.insert(c.settings.lights.count);
    EXPECT_EQ(c.settings.lights.source, LightSource::generated);
    EXPECT_TRUE(same_truth_but(c.settings, now, varied)) << c.id;
    EXPECT_FALSE(same_truth_but(c.settings, now, {})) << c.id;
  }
  EXPECT_EQ(counts, (std::set<int>{16, 64, 256, 1024}));
}

TEST(StudyHere, PresetsBringTheirMethodsAndMistakesOnly) {
  const Settings now = settings_now();
  size_t presets = 0;
  for (const StudyCase& c : plan_here("tradeoff", now).cases) {
    EXPECT_TRUE(same_truth_but(c.settings, now, {})) << c.id;
    presets += c.at.front().path == "preset";
  }
  EXPECT_GT(presets, 5u);
}

TEST(StudyHere, OnlyStudiesOfOneScenesPictureCanRun) {
  std::vector<std::string> ids;
  for (const BuiltinStudy& b : builtin_studies())
    if (can_run_here(load_study(b.id))) ids.push_back(b.id);
  for (const char* id : {"accumulation", "lights", "normals", "positions", "quick", "tradeoff"})
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
  for (const char* id : {"presets", "forward-or-deferred"})
    EXPECT_EQ(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
}

TEST(StudyHere, EachTruthOptionButTheSizeCounts) {
  const Settings now = settings_now();
  Settings other = now;
  other.size = {1, 1};
  other.layout = Layout::nclgl;
  other.view.pick = 3;
  EXPECT_TRUE(same_truth_but(now, other, {}));
  other.lights.seed = 6;
  EXPECT_FALSE(same_truth_but(now, other, {}));
  EXPECT_TRUE(same_truth_but(now, other, {"lights.seed"}));
}

}  // namespace
}  // namespace gbl
