#include "renderer/lessons/lessons.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/inspect/views.h"
#include "renderer/light/light_volume.h"
#include "renderer/light/lights.h"
#include "renderer/options/presets.h"
#include "renderer/scenes/builtin_scenes.h"

namespace gbl {
namespace {

TEST(Lessons, ThoseOfTheLabAreThere) {
  EXPECT_EQ(lesson_ids(), (std::vector<std::string>{"what-is-in-a-g-buffer", "three-ways-to-lose-a-light",
                                                    "learnopengl-in-three-stages", "where-is-the-light-blocked",
                                                    "a-mirror-is-another-frame", "what-does-a-normal-cost",
                                                    "where-depth-precision-goes", "ten-minutes"}))
      << "as they are taught";
  const Lesson g_buffer = load_lesson("what-is-in-a-g-buffer");
  EXPECT_EQ(g_buffer.title, "What is in a G-buffer");
  EXPECT_EQ(g_buffer.steps.size(), 8u);
  const Lesson lost = load_lesson("three-ways-to-lose-a-light");
  EXPECT_EQ(lost.title, "Three ways to lose a light");
  EXPECT_EQ(lost.steps.size(), 6u);
  EXPECT_EQ(load_lesson("learnopengl-in-three-stages").steps.size(), 5u);
  EXPECT_EQ(load_lesson("where-is-the-light-blocked").steps.size(), 8u);
  EXPECT_EQ(load_lesson("a-mirror-is-another-frame").steps.size(), 6u);
}

// A lecture of ten minutes.
TEST(Lessons, TheLectureTakesTenMinutes) {
  double minutes = 0;
  for (const LessonStep& step : load_lesson("ten-minutes").steps) minutes += step.minutes;
  EXPECT_EQ(minutes, 10);
}

// "Half of the codes at 2 units", "0.06 at 1000 units, and 6 at 10000".
TEST(Lessons, StepsOfStoredDepthAreAsTheySay) {
  const Camera c = settings_at(load_lesson("where-depth-precision-goes"), 0).camera;
  EXPECT_NEAR(range_from_depth(c, 0.5), 2, 0.001);
  const auto step = [&](double range) {
    const double d = depth_from_range(c, range), code = std::exp2(-24);
    return range_from_depth(c, std::min(d + code / 2, 1.0)) - range_from_depth(c, d - code / 2);
  };
  EXPECT_NEAR(step(1000), 0.06, 0.002);
  EXPECT_NEAR(step(9990), 6, 0.2);
}

// "Of eighty codes only about one lies near the sphere": those within half a step of it, of 255^3.
TEST(Lessons, FewCodesOfThreeBytesAreDirections) {
  int near = 0;
  for (int x = 0; x < 256; ++x)
    for (int y = 0; y < 256; ++y)
      for (int z = 0; z < 256; ++z) near += std::abs(glm::length(glm::dvec3(x, y, z) - 127.5) - 127.5) < 0.5;
  EXPECT_NEAR(256.0 * 256 * 256 / near, 80, 5);
}

// "Ten maps for three lights": three of the sun, six of the lamp, one of the spot.
TEST(Lessons, TheBlockedLightsHaveTenMaps) {
  const Lesson lesson = load_lesson("where-is-the-light-blocked");
  const Settings third = settings_at(lesson, 2);
  const Scene scene = load_scene(third.scene);
  EXPECT_EQ(resolve_frame(third, scene, {}).shadows.maps.size(), 10u);
  const ResolvedFrame last = resolve_frame(settings_at(lesson, 7), scene, {});
  EXPECT_EQ(last.shadows.with, 1);
  EXPECT_EQ(last.shadows.without, 2);
  EXPECT_EQ(last.lights[static_cast<size_t>(last.shadows.maps[0].light)].kind, LightKind::directional);
}

// The last step is the preset with the mistakes fixed, but for what is looked at.
TEST(Lessons, LearnOpenGLEndsWhereItsMendedPresetStands) {
  Settings last = settings_at(load_lesson("learnopengl-in-three-stages"), 4);
  const Settings fixed = preset("learnopengl-fixed").make();
  last.view = fixed.view;
  EXPECT_EQ(last, fixed);
}

TEST(Lessons, EveryPatchChangesSomethingAndEveryViewCanBeShown) {
  for (const std::string& id : lesson_ids()) {
    const Lesson lesson = load_lesson(id);
    Settings before = preset(lesson.preset).make();
    for (size_t k = 0; k < lesson.steps.size(); ++k) {
      const LessonStep& step = lesson.steps[k];
      const Settings now = settings_at(lesson, k);
      EXPECT_EQ(now == before, step.set.empty()) << id << " step " << k + 1;
      if (!step.view.empty()) {
        EXPECT_EQ(why_missing(view_by_id(step.view).view, now), "") << id << " step " << k + 1;
      }
      EXPECT_NEAR(glm::length(now.camera.orientation), 1, 1e-12);
      before = now;
    }
  }
}

TEST(Lessons, SteppingIsAPureFunction) {
  const Lesson lesson = load_lesson("three-ways-to-lose-a-light");
  const Settings third = settings_at(lesson, 2);
  settings_at(lesson, 5);
  EXPECT_EQ(settings_at(lesson, 2), third);
  EXPECT_EQ(third.camera.near, 10);                              // its own patch
  EXPECT_EQ(third.lights.cull, LightCull::flip);                 // the patch of the step before
  EXPECT_EQ(third.normal, preset(lesson.preset).make().normal);  // untouched
  EXPECT_EQ(settings_at(load_lesson(lesson.id), 2), third);
}

// The numbers that the sentences speak of, and that each loss is the one its step explains.
TEST(Lessons, ThreeWaysStandWhereTheySay) {
  const Lesson lesson = load_lesson("three-ways-to-lose-a-light");
  const auto at = [&](size_t k) {
    struct Pose {
      double d, range, scale, corner;
      Faces faces;
    };
    const Settings s = settings_at(lesson, k);
    const Light l = generated_lights(LightGrid{}, s.lights.count, s.lights.seed, s.time_s)[37];
    const double d = glm::length(l.position - s.camera.position),
                 scale = volume_scale(s.lights.volume.fit, s.lights.volume.level, VolumeShape::sphere);
    const double corner = s.camera.near * near_corner_factor(s.camera, 16.0 / 9);
    return Pose{d, l.range, scale, corner,
                faces_to_draw(cull_rule(s.lights.cull, corner), d, l.range, l.range * scale)};
  };
  EXPECT_NEAR(at(0).d, 467.6, 0.05);
  EXPECT_LT(at(0).d, at(0).range);
  EXPECT_EQ(at(0).faces, Faces::front);  // none to be seen from inside
  EXPECT_EQ(at(1).faces, Faces::back);

  EXPECT_NEAR(at(2).d, 518, 1e-9);
  EXPECT_GT(at(2).d, at(2).range * at(2).scale);                         // outside the mesh, vertices included
  EXPECT_LT(at(2).d - at(2).range, settings_at(lesson, 2).camera.near);  // its front is before the near plane
  EXPECT_EQ(at(2).faces, Faces::front);
  EXPECT_NEAR(at(2).range + at(2).corner, 527.1, 0.05);
  EXPECT_EQ(at(3).faces, Faces::back);

  EXPECT_NEAR(at(4).d, 560, 1e-9);
  EXPECT_NEAR(at(4).range * at(4).scale, 646.8, 0.05);
  EXPECT_EQ(settings_at(lesson, 4).lights.volume.clip, VolumeClip::none);
  EXPECT_EQ(at(4).faces, Faces::front);
  EXPECT_EQ(at(5).faces, Faces::back);

  // Inside the mesh of step 5, not only nearer than its corners: behind every face.
  const VolumeMesh mesh = icosphere(0);
  const Settings s = settings_at(lesson, 4);
  const Light l = generated_lights(LightGrid{}, 64, s.lights.seed, 0)[37];
  const glm::dvec3 eye = (s.camera.position - l.position) / (l.range * at(4).scale);
  for (size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const glm::dvec3 a(mesh.vertices[mesh.triangles[t]]), b(mesh.vertices[mesh.triangles[t + 1]]),
        c(mesh.vertices[mesh.triangles[t + 2]]);
    EXPECT_LT(glm::dot(glm::cross(b - a, c - a), eye - a), 0);
  }
}

// ---- bad files --------------------------------------------------------------------------------------------
std::string file(const std::string& steps,
                 const std::string& head = R"("version": 1, "title": "T", "preset": "start")") {
  return fmt::format(R"({{{}, "steps": {}}})", head, steps);
}

std::string refusal(const std::string& text) {
  try {
    parse_lesson("bad", text);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    EXPECT_EQ(std::string(e.what()).find("assets/lessons/bad.json"), 0u) << e.what();
    return e.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return {};
}

void expect_refused(const std::string& text, std::initializer_list<const char*> parts) {
  const std::string message = refusal(text);
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

const char* const kGoodStep = R"({"say": "S", "set": {"lights": {"count": 3}}, "view": "normal", "layout": "large"})";

TEST(LessonFiles, AGoodOneIsRead) {
  const Lesson l =
      parse_lesson("good", file(fmt::format("[{}, {}]", kGoodStep, R"({"say": "A", "question": "Q", "answer": "B"})")));
  EXPECT_EQ(l.id, "good");
  ASSERT_EQ(l.steps.size(), 2u);
  EXPECT_EQ(l.steps[0].view, "normal");
  EXPECT_TRUE(l.steps[0].large);
  EXPECT_FALSE(l.steps[1].large);
  EXPECT_EQ(l.steps[1].answer, "B");
  EXPECT_EQ(settings_at(l, 1).lights.count, 3);
}

TEST(LessonFiles, VersionsAreChecked) {
  expect_refused(file("[]", R"("version": 7, "title": "T", "preset": "start", "mood": "new")"),
                 {"version 7", "up to 1", "update the program"});
  expect_refused(file("[]", R"("title": "T", "preset": "start")"), {"no \"version\""});
  expect_refused(file("[]", R"("version": "1", "title": "T", "preset": "start")"), {"not a whole number"});
}

TEST(LessonFiles, MistakesNameTheStep) {
  const auto second = [](const char* step) { return file(fmt::format("[{}, {}]", kGoodStep, step)); };
  expect_refused(second(R"({"set": {}})"), {"step 2", "\"say\" is missing"});
  expect_refused(second(R"({"say": ""})"), {"step 2", "\"say\" is missing or empty"});
  expect_refused(second(R"({"say": 5})"), {"step 2", "\"say\" is 5"});
  expect_refused(second(R"({"say": "S", "set": {"lights.cul": "back"}})"),
                 {"step 2", "lights.cul", "did you mean 'lights.cull'"});
  expect_refused(second(R"({"say": "S", "set": {"lights.cull": "bakc"}})"), {"step 2", "did you mean 'back'"});
  expect_refused(second(R"({"say": "S", "set": {"ambient": -1}})"), {"step 2", "ambient"});
  expect_refused(second(R"({"say": "S", "set": 3})"), {"step 2", "must be a JSON object"});
  expect_refused(second(R"({"say": "S", "view": "normals"})"),
                 {"step 2", "unknown view 'normals'", "did you mean 'normal'"});
  expect_refused(second(R"({"say": "S", "layout": "big"})"), {"step 2", "unknown layout 'big'", "mosaic, large"});
  expect_refused(second(R"({"say": "S", "qestion": "Q"})"),
                 {"step 2", "unknown member \"qestion\"", "did you mean 'question'"});
  expect_refused(second(R"({"say": "S", "question": "Q"})"), {"step 2", "must come together"});
  expect_refused(second(R"("say")"), {"step 2", "must be a JSON object"});
}

TEST(LessonFiles, TheHeadIsChecked) {
  expect_refused("[1]", {"must be a JSON object"});
  expect_refused("{\"version\": 1,\n \"title\" \"T\"}", {"bad.json:2", "not valid JSON"});
  expect_refused(file("[]"), {"at least one step"});
  expect_refused(file("{}"), {"at least one step"});
  expect_refused(file("[]", R"("version": 1, "title": "T")"), {"\"preset\" is missing"});
  expect_refused(file("[]", R"("version": 1, "title": "T", "preset": "strat")"),
                 {"unknown preset", "did you mean 'start'"});
  expect_refused(file("[]", R"("version": 1, "title": "T", "preset": "start", "stps": 1)"),
                 {"unknown member \"stps\""});
  for (const char* order : {"0", "1.5", "\"first\""})
    expect_refused(file("[]", fmt::format(R"("version": 1, "order": {}, "title": "T", "preset": "start")", order)),
                   {"\"order\" is", "whole number from 1"});
}

TEST(LessonPlaces, AreAStepAfterAColon) {
  const std::string id = "what-is-in-a-g-buffer";
  const size_t count = load_lesson(id).steps.size();
  EXPECT_EQ(load_lesson_place(id).step, 0u);
  EXPECT_EQ(load_lesson_place(id + ":1").step, 0u);
  EXPECT_EQ(load_lesson_place(fmt::format("{}:{}", id, count)).step, count - 1);
  EXPECT_EQ(load_lesson_place(id + ":2").lesson.id, id);
  for (const std::string& step : {std::string("0"), std::string("-1"), std::to_string(count + 1)}) try {
      load_lesson_place(fmt::format("{}:{}", id, step));
      ADD_FAILURE() << step;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(fmt::format("give 1 to {}", count)), std::string::npos) << e.what();
    }
  EXPECT_THROW(load_lesson_place(id + ":"), Error);  // a name
  EXPECT_THROW(load_lesson_place(id + ":two"), Error);
}

TEST(LessonFiles, UnknownLessonListsTheKnownOnes) {
  try {
    load_lesson("three-ways");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("what-is-in-a-g-buffer"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace gbl
