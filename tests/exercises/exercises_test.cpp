// Exercises as data, answers as files, and what is judged without a driver.
#include <fmt/format.h>
#include <fstream>
#include <set>

#include "renderer/base/json.h"
#include "renderer/base/resources.h"
#include "renderer/exercises/exercise.h"
#include "renderer/exercises/judge_answer.h"
#include "renderer/exercises/task_text.h"
#include "renderer/lessons/lessons.h"
#include "renderer/options/settings_json.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

TEST(Exercises, AllOfThemCanBeOpened) {
  const std::vector<Exercise> all = load_exercises();
  EXPECT_GE(all.size(), 10u);
  std::set<int> places;
  for (const Exercise& e : all) {
    EXPECT_TRUE(places.insert(e.order).second) << e.id << ": another exercise has its place";
    EXPECT_LE(state_of(e).size.x, 640) << e.id << ": judged at its size, also on a slow machine";
    EXPECT_TRUE(contains(task_text(e), e.title)) << e.id;
    EXPECT_TRUE(contains(task_markdown(e), "--check")) << e.id;
    const std::string begun = template_of(e);
    if (e.answer == AnswerKind::glsl || e.answer == AnswerKind::layout)
      EXPECT_FALSE(e.start.empty()) << e.id;
    else
      EXPECT_EQ(parse_json(begun, e.id)["exercise"], e.id);
  }
}

TEST(Exercises, AnUnknownOneIsAnsweredWithTheNearest) {
  const std::string line = error_line(ExitCode::bad_input, [] { load_exercise("quad-spase"); });
  EXPECT_TRUE(contains(line, "did you mean 'quad-space'")) << line;
}

Json one() {
  return Json::parse(R"({"version": 1, "title": "t", "source": "s", "task": "k", "hint": "h", "tolerance": "o",
    "preset": "start", "answer": "settings", "check": {"free": ["lights.cull"], "bounds": [{"measure": "lost_share", "at_most": 0}]}})");
}
std::string refused(const Json& json) {
  return error_line(ExitCode::bad_input, [&] { parse_exercise("one", json.dump()); });
}

TEST(Exercises, WhatIsWrongWithAFileIsNamed) {
  EXPECT_NO_THROW(parse_exercise("one", one().dump()));
  Json j = one();
  j["answer"] = "setting";
  EXPECT_TRUE(contains(refused(j), "did you mean 'settings'"));
  j = one(), j["chekc"] = 1;
  EXPECT_TRUE(contains(refused(j), "did you mean 'check'"));
  j = one(), j["check"]["bounds"][0]["measure"] = "lost_shar";
  EXPECT_TRUE(contains(refused(j), "did you mean 'lost_share'"));
  j = one(), j["check"]["bounds"][0].erase("at_most");
  EXPECT_TRUE(contains(refused(j), "at_least"));
  j = one(), j["set"] = {{"lights.cul", "back"}};
  EXPECT_TRUE(contains(refused(j), "did you mean 'lights.cull'"));
  j = one(), j["version"] = 2;
  EXPECT_TRUE(contains(refused(j), "newer program"));
  j = one(), j["answer"] = "glsl";
  j["check"] = {{"call", "vec4(0)"}, {"inputs", "depth"}, {"expected", "input"}, {"error", "angle"}, {"at_most", 1}};
  EXPECT_TRUE(contains(refused(j), "did you mean 'depths'"));
}

// ---- answers -------------------------------------------------------------------------------------------------------

std::string no_answer(const char* exercise, const char* text) {
  return error_line(ExitCode::bad_input, [&] { parse_answer(load_exercise(exercise), text, "a.json"); });
}

TEST(Answers, ABrokenFileHasLineAndColumn) {
  EXPECT_TRUE(no_answer("quad-space", "{\n  \"answer\": \"view\",,\n}").starts_with("a.json:2:20: not valid JSON"));
  EXPECT_TRUE(
      no_answer("quad-space", "{\n  \"answer\":   \"scren\"}").starts_with("a.json:2:15: 'scren' is no choice"));
  EXPECT_TRUE(contains(no_answer("quad-space", "{\"answer\": \"scren\"}"), "did you mean 'screen'"));
  EXPECT_TRUE(no_answer("quad-space", "{\"answer\": 3}").starts_with("a.json:1:12: the answer is 3"));
  EXPECT_TRUE(no_answer("quad-space", "{\"exercise\": \"light-shape\", \"answer\": \"view\"}")
                  .starts_with("a.json:1:14: this answers 'light-shape'"));
  EXPECT_TRUE(contains(no_answer("quad-space", "{\"exercise\": \"quad-space\"}"), "\"answer\" is missing"));
  EXPECT_TRUE(no_answer("spot-volume", "{\"answer\": \"two\"}").starts_with("a.json:1:12: the answer is \"two\""));
  EXPECT_TRUE(contains(no_answer("tangent-face", "{\"answer\": [1]}"), "[x, y]"));
  EXPECT_TRUE(contains(no_answer("tangent-face", "{\"answer\": [320, 0]}"), "outside"));
  EXPECT_TRUE(contains(no_answer("choose-threshold", "{\"answer\": {\"range.treshold\": 1}}"), "range.threshold"));
  EXPECT_TRUE(contains(no_answer("choose-threshold", "range.threshold=0.02\nrange.threshold\n"), "a.json:2:1"));
  EXPECT_TRUE(contains(no_answer("choose-threshold", "range.threshold=7\n"), "a.json:1:1"));
}

TEST(Answers, SettingsComeAsAPatchAsLinesAndAsAState) {
  const Exercise e = load_exercise("choose-threshold");
  const std::vector<Assignment> wanted = {{"range.threshold", 0.25}};
  EXPECT_EQ(parse_answer(e, R"({"answer": {"range": {"threshold": 0.25}}})", "a").set, wanted);
  EXPECT_EQ(parse_answer(e, "# tried\n  --set range.threshold=0.25  # this\n", "a").set, wanted);
  Settings s = state_of(e);
  s.range.threshold = 0.25, s.size = {800, 450}, s.view.main = "depth";
  EXPECT_EQ(parse_answer(e, settings_text(s), "a").set, wanted) << "size and view are no part of it";
}

// ---- what is judged without a driver -------------------------------------------------------------------------------

TEST(HashedChoices, OnlyTheRightOneHasTheHashAndTheFileDoesNotNameIt) {
  for (const Exercise& e : load_exercises()) {
    if (needs_gl(e)) continue;
    int right = 0;
    for (const ExerciseChoice& c : e.choices) {
      const ExerciseVerdict v = judge_answer(e, {.choice = c.id}, {});
      right += v.right;
      EXPECT_EQ(v.hint.empty(), v.right);
    }
    EXPECT_EQ(right, 1) << e.id;
    EXPECT_EQ(e.hash.size(), 64u);
    Exercise salted = e;
    salted.salt += "x";
    EXPECT_NE(hash_of_choice(salted, e.choices[0].id), hash_of_choice(e, e.choices[0].id)) << "the salt counts";
  }
}

// A student may change what the exercise leaves free, and nothing else: the tools are not even asked.
TEST(SettingsAnswers, OtherOptionsStayAsTheyAre) {
  const Exercise e = load_exercise("choose-threshold");
  const ExerciseVerdict v = judge_answer(e, {.where = "a", .set = {{"lights.count", 1}}}, {});
  EXPECT_FALSE(v.right);
  EXPECT_TRUE(contains(v.off, "lights.count")) << v.off;
}

TEST(Verdicts, ComeBackFromJson) {
  const ExerciseVerdict v{true, "a=1", "b", "c"};
  const ExerciseVerdict back = verdict_of_json(to_json(v));
  EXPECT_EQ(back.right, v.right);
  EXPECT_EQ(back.measured + back.off + back.hint, "a=1bc");
}

// ---- functions -----------------------------------------------------------------------------------------------------

GlslError error_with(const GlslCheck& check, const std::function<glm::dvec4(glm::dvec4, glm::dvec4)>& f) {
  const std::vector<GlslInput> inputs = inputs_of(check);
  std::vector<glm::vec4> results;
  for (const GlslInput& in : inputs) results.emplace_back(f(in.a, in.b));
  return error_of(check, inputs, results);
}

// 1/(1/far + (1 - depth)(1/near - 1/far)): the same distance, written another way than the reference.
double range(double depth, double near, double far) { return 1 / (1 / far + (1 - depth) * (1 / near - 1 / far)); }

TEST(GlslTasks, ReferencesAgreeWithOtherWaysToWriteThem) {
  EXPECT_LT(error_with({"", "depths", "linear-depth", "absolute"},
                       [](auto a, auto) { return glm::dvec4((range(a.x, a.y, a.z) - a.y) / (a.z - a.y), 0, 0, 0); })
                .most,
            1e-6)
      << "results are rounded to float";
  EXPECT_LT(error_with({"", "pixels-with-depth", "view-position", "relative"},
                       [](auto a, auto b) {
                         const double r = range(a.z, b.z, b.w);
                         return glm::dvec4(r * a.x * b.x, r * a.y * b.y, -r, 1);
                       })
                .most,
            1e-6);
  EXPECT_LT(error_with({"", "lamps", "ramp-range", "relative"},
                       [](auto a, auto) {  // by halving, from the falloff alone
                         double near = 0, far = 1e6;
                         for (int i = 0; i < 200; ++i) {
                           const double x = (near + far) / 2;
                           (a.y / (0.2 + 0.4 * x + 0.4 * x * x) > a.z ? near : far) = x;
                         }
                         return glm::dvec4(a.x * near, 0, 0, 0);
                       })
                .most,
            1e-6);
}

TEST(GlslTasks, OctahedronPointsAreThoseOfTheDirections) {
  const GlslCheck check{"", "octahedron-points", "octahedral-direction", "angle"};
  const std::vector<GlslInput> directions = inputs_of({"", "unit-directions", "input", "angle"});
  std::vector<glm::vec4> results;
  for (const GlslInput& d : directions) results.push_back(d.a);
  EXPECT_LT(error_of(check, inputs_of(check), results).most, 2e-5) << "degrees: points are rounded to float";
}

TEST(GlslTasks, WhatIsNoNumberIsInfinitelyWrong) {
  const GlslCheck check{"", "depths", "linear-depth", "absolute"};
  EXPECT_TRUE(std::isinf(error_with(check, [](auto, auto) { return glm::dvec4(NAN); }).most));
}

TEST(Exercises, ThoseOfALessonAreThere) {
  const std::vector<std::string> known = exercise_ids();
  size_t named = 0;
  for (const std::string& id : lesson_ids())
    for (const std::string& e : load_lesson(id).exercises) {
      EXPECT_NE(std::find(known.begin(), known.end(), e), known.end()) << id << " names " << e;
      ++named;
    }
  EXPECT_GT(named, 0u);
}

}  // namespace
}  // namespace gbl
