// The catalogue of pitfalls as data: complete, readable, and refused where it is wrong.
#include "renderer/study/pitfalls/catalogue.h"

#include <gtest/gtest.h>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/pitfalls/judge.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

const std::vector<PitfallEntry>& catalogue() {
  static const std::vector<PitfallEntry> all = load_pitfalls();
  return all;
}

std::set<std::string> shown_by(const PitfallEntry& e, PitfallSide side) {
  std::set<std::string> out;
  for (const Unsound& u : unsound_choices(settings_of(e, side))) out.insert(u.pitfall);
  return out;
}

TEST(Pitfalls, EveryUnsoundValueAndEveryMistakeHasAnEntryThatShowsIt) {
  const auto shows = [](const std::string& id) {
    for (const PitfallEntry& e : catalogue())
      if (e.id == id) return shown_by(e, PitfallSide::broken).contains(id);
    return false;
  };
  for (const Option& o : options())
    for (const ValueRow& r : o.values)
      EXPECT_TRUE(r.sound() || shows(id_of(r.pitfall))) << o.path << "=" << r.id << ": " << id_of(r.pitfall);
  for (const MistakeRow& m : mistakes()) EXPECT_TRUE(shows(m.id)) << m.id;
}

TEST(Pitfalls, TheFixedSideDoesNotContainTheFailure) {
  for (const PitfallEntry& e : catalogue()) {
    const std::vector<Unsound> broken = unsound_choices(settings_of(e, PitfallSide::broken));
    const auto of_both = [&](const Unsound& u) {
      return std::any_of(broken.begin(), broken.end(),
                         [&](const Unsound& b) { return b.path == u.path && b.value == u.value; });
    };
    for (const Unsound& u : unsound_choices(settings_of(e, PitfallSide::fixed)))
      EXPECT_TRUE(u.pitfall != e.id || of_both(u)) << e.id;
    EXPECT_NE(settings_of(e, PitfallSide::fixed), settings_of(e, PitfallSide::broken)) << e.id;
  }
}

TEST(Pitfalls, BrokenAndFixedHaveOneTruthUnlessTheModelFails) {
  const std::set<std::string> of_the_model = {"cutoff-5-256", "infinite-range-light", "linear-falloff-kink",
                                              "ramp-kink", "no-srgb"};
  for (const PitfallEntry& e : catalogue()) {
    const bool same = same_truth(settings_of(e, PitfallSide::broken), settings_of(e, PitfallSide::fixed));
    EXPECT_NE(same, of_the_model.contains(e.id)) << e.id;
  }
}

TEST(Pitfalls, AreInOrderAndTheLectureSetIsWhole) {
  std::set<int> places;
  std::set<std::pair<std::string, int>> orders;
  for (const PitfallEntry& e : catalogue()) {
    EXPECT_TRUE(e.lecture == 0 || places.insert(e.lecture).second) << e.id;
    EXPECT_TRUE(orders.insert({e.group, e.order}).second) << e.id;
  }
  EXPECT_EQ(places.size(), 7u);
  EXPECT_EQ(*places.rbegin(), 7);
}

TEST(Pitfalls, WhatIsLeftOutIsSaidAndIsNotIn) {
  std::set<std::string> in;
  for (const PitfallEntry& e : catalogue()) in.insert(e.id);
  for (const AbsentPitfall& a : absent_pitfalls()) {
    EXPECT_FALSE(in.contains(a.id)) << a.id;
    EXPECT_GT(std::string(a.why).size(), 10u) << a.id;
    EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { load_pitfall(a.id); }), a.why));
  }
  EXPECT_GE(in.size() + absent_pitfalls().size(), 70u);
}

TEST(Pitfalls, AnUnknownOneIsAnsweredWithTheNearest) {
  const std::string line = error_line(ExitCode::bad_input, [] { load_pitfall("near-plane-cat"); });
  EXPECT_TRUE(contains(line, "did you mean 'near-plane-cut'")) << line;
}

// ---- files ---------------------------------------------------------------------------------------------------------

Json file() {
  Json j = {{"version", 1}, {"group", "volumes"}, {"preset", "start"}, {"view", "final"}, {"metric", "lost_share"}};
  for (const char* text : {"title", "source", "symptom", "cause", "question", "do", "dont", "impact", "see", "still"})
    j[text] = "words";
  j["broken"] = {{"lights.cull", "back"}}, j["fixed"] = {{"lights.cull", "front"}};
  j["broken_at_least"] = 0.5, j["fixed_at_most"] = 0;
  return j;
}

std::string refusal(const Json& j) {
  return error_line(ExitCode::bad_input, [&] { parse_pitfall("mine", j.dump()); });
}

TEST(PitfallFile, IsRead) {
  Json j = file();
  j["set"] = {{"lights.only", 37}}, j["toward_zero"] = {{"broken_at_least", 0.7}, {"fixed_at_most", 0.1}};
  j["blind"] = {{"set", {{"lights.only", 3}}}, {"at_most", 0.2}, {"why", "it is far"}};
  const PitfallEntry e = parse_pitfall("mine", j.dump());
  EXPECT_EQ(settings_of(e, PitfallSide::broken).lights.cull, LightCull::back);
  EXPECT_EQ(settings_of(e, PitfallSide::fixed).lights.cull, LightCull::front);
  EXPECT_EQ(settings_of(e, PitfallSide::fixed).lights.only, 37);
  EXPECT_EQ(settings_of(e, PitfallSide::blind).lights.cull, LightCull::back);
  EXPECT_EQ(settings_of(e, PitfallSide::blind).lights.only, 3);
  EXPECT_EQ(bounds_on(e, {}).broken_at_least, 0.5);
  EXPECT_EQ(bounds_on(e, {.half_blend = StoreRounding::toward_zero}).broken_at_least, 0.7);
}

TEST(PitfallFile, APathLeadsFromOneCameraToAnother) {
  Json j = file();
  j["path"] = {{"from", {{"camera.position", {0, 0, 0}}}}, {"to", {{"camera.position", {8, 0, 4}}}}};
  const PitfallEntry e = parse_pitfall("mine", j.dump());
  EXPECT_EQ(camera_on_path(e, 0.25).position, glm::dvec3(2, 0, 1));
  EXPECT_EQ(camera_on_path(e, 1).fov, settings_of(e, PitfallSide::broken).camera.fov);
  j["path"]["via"] = 1;
  EXPECT_TRUE(contains(refusal(j), "unknown member \"via\""));
}

TEST(PitfallFile, TheModelThatIsMeantJudgesTheBrokenSideOnly) {
  Json j = file();
  j["truth"] = {{"colour", "srgb"}}, j["set"] = {{"colour", "as-tutorial"}};
  const PitfallEntry e = parse_pitfall("mine", j.dump());
  EXPECT_EQ(truth_of(e, PitfallSide::broken).colour, Colour::srgb);
  EXPECT_EQ(settings_of(e, PitfallSide::broken).colour, Colour::as_tutorial);
  EXPECT_EQ(truth_of(e, PitfallSide::fixed).colour, Colour::as_tutorial);
}

TEST(PitfallFile, WhatIsWrongIsNamedWithItsPlace) {
  const struct {
    const char* member;
    Json value;
    const char* named;
  } kWrong[] = {{"metric", "lost_shar", "did you mean 'lost_share'"},
                {"group", "volume", "did you mean 'volumes'"},
                {"view", "finale", "did you mean 'final'"},
                {"preset", "strat", "did you mean 'start'"},
                {"symptom", "", "\"symptom\" is missing or empty"},
                {"broken", {{"lights.cul", "back"}}, "lights.cul"},
                {"fixed", {{"lights.cull", "sideways"}}, "sideways"},
                {"fixed_at_most", 0.5, "must be more than"},
                {"broken_at_least", "much", "must be a number"},
                {"lecture", 1.5, "whole number"},
                {"version", 2, "newer program"},
                {"fxed", 1, "did you mean 'fixed'"},
                {"blind", {{"set", Json::object()}, {"at_most", 1}}, "\"why\""}};
  for (const auto& w : kWrong) {
    Json j = file();
    j[w.member] = w.value;
    const std::string line = refusal(j);
    EXPECT_TRUE(contains(line, "assets/pitfalls/mine.json")) << line;
    EXPECT_TRUE(contains(line, w.named)) << line;
  }
}

// ---- the judge -----------------------------------------------------------------------------------------------------

PitfallResult judged(const Json& j, double broken, double fixed, double blind = 0) {
  const PitfallEntry e = parse_pitfall("mine", j.dump());
  const auto measure = [&](const Settings& s, const Settings& meant) {
    EXPECT_EQ(s.size, glm::ivec2(16, 9));
    PitfallEvidence out{.setup = {s, nullptr}, .meant = meant};
    const double value = s.lights.cull == LightCull::front ? fixed : s.lights.only == 3 ? blind : broken;
    out.measured.errors.max_linear = value;
    return out;
  };
  return judge_pitfall(e, {16, 9}, {}, {}, measure);
}

TEST(PitfallJudge, SaysWhatIsNotAsCatalogued) {
  Json j = file();
  j["metric"] = "max_linear";
  EXPECT_TRUE(judged(j, 0.5, 0).holds());
  EXPECT_TRUE(contains(judged(j, 0.4, 0).wrong, "broken: max_linear is 0.4, not at least 0.5"));
  EXPECT_TRUE(contains(judged(j, 0.5, 0.1).wrong, "fixed: max_linear is 0.1, not at most 0"));
  EXPECT_FALSE(judged(j, 0.5, NAN).holds()) << "what is no number holds no bound";
  j["blind"] = {{"set", {{"lights.only", 3}}}, {"at_most", 0.1}, {"why", "it is far"}};
  EXPECT_TRUE(judged(j, 0.5, 0, 0.1).holds());
  EXPECT_TRUE(contains(judged(j, 0.5, 0, 0.2).wrong, "where it hides: max_linear is 0.2"));
}

TEST(PitfallJudge, SkipsWhatTheDeviceCannotDraw) {
  Json j = file();
  j["metric"] = "max_linear", j["broken"]["lights.method"] = "tiled";
  const PitfallResult r = judged(j, 0.5, 0);  // DeviceLimits{} has no compute shaders
  EXPECT_TRUE(contains(r.skipped, "lights.method")) << r.skipped;
}

TEST(PitfallJudge, DoesNotSkipWhatNoDeviceCanDraw) {
  Json j = file();
  j["metric"] = "max_linear", j["set"] = {{"camera.far", 0.5}};
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { judged(j, 0.5, 0); }), "mine: camera.far"));
}

}  // namespace
}  // namespace gbl
