// What the window says: captions, and the lessons from the keyboard.
#include <gtest/gtest.h>

#include "renderer/lessons/lessons.h"
#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

TEST(Captions, SayWhatChangedWhatItCostsAndWhetherItIsSound) {
  const Settings before = preset("start").make();
  Settings after = before;
  after.lights.cull = LightCull::back;
  EXPECT_EQ(describe_change(before, after).whole(),
            "Cull: flip → back. Front faces only: nothing is left to draw once the camera is inside. "
            "UNSOUND: backface-cull-inside.");
  after = before;
  after.normal.encoding = NormalEncoding::oct8;
  EXPECT_NE(describe_change(before, after).text.find("16 bits (was 32 bits)"), std::string::npos);
  after = before;
  after.lights.method = LightMethod::auto_;
  const Settings automatic = after;
  after.lights.cull = LightCull::back;
  EXPECT_EQ(describe_change(automatic, after).pitfall, "") << "auto leaves out what is unsound";
  EXPECT_NE(describe_change(automatic, after).text.find("only while this choice is sound"), std::string::npos);
  after = before;
  after.layout_file = "folder/mine.glsl@0123456789abcdef";
  EXPECT_EQ(value_text(option("layout"), after), "mine.glsl") << "it is what is drawn";
  EXPECT_EQ(value_text(option("layout"), before), row(before.layout).label);
  after = before;
  after.camera.position.x += 1;
  EXPECT_TRUE(describe_change(before, after).text.empty());
}

TEST(Captions, EndAfterSixSeconds) {
  Desk desk;
  EXPECT_FALSE(desk.requests.wake_in);
  desk.press("c");
  ASSERT_TRUE(desk.requests.wake_in);
  EXPECT_NEAR(*desk.requests.wake_in, kCaptionSeconds, 1e-9);
  desk.seconds += kCaptionSeconds;
  desk.frame();
  EXPECT_FALSE(desk.requests.wake_in);
}

TEST(Lessons, EveryLessonIsSteppedToItsEndAndBack) {
  const std::vector<std::string> ids = lesson_ids();
  for (size_t i = 0; i < ids.size(); ++i) {
    const Lesson lesson = load_lesson(ids[i]);
    for (const bool present : {false, true}) {
      Desk desk({1600, 900}, present);
      const glm::ivec2 size = desk.settings.size;
      desk.press("PgDn");
      for (size_t k = 0; k < i; ++k) desk.press("Down");
      desk.press("Enter");
      for (size_t step = 0; step < lesson.steps.size(); ++step) {
        if (step > 0) desk.press("PgDn");
        desk.press("Enter");
        Settings expected = settings_at(lesson, step);
        expected.size = size;
        expected.view.main = desk.settings.view.main;
        EXPECT_EQ(desk.settings, expected) << ids[i] << " step " << step + 1;
        if (!lesson.steps[step].view.empty()) {
          EXPECT_EQ(desk.settings.view.main, lesson.steps[step].view);
        }
        EXPECT_EQ(desk.visible() <= 1, lesson.steps[step].large);
        EXPECT_TRUE(desk.ui.cut_texts().empty())
            << ids[i] << " step " << step + 1 << ": " << desk.ui.cut_texts().front();
      }
      const Settings last = desk.settings;
      desk.press("PgDn");
      EXPECT_EQ(desk.settings, last) << "the end is the end";
      for (size_t step = 1; step < lesson.steps.size(); ++step) desk.press("PgUp");
      Settings first = settings_at(lesson, 0);
      first.size = size;
      first.view.main = desk.settings.view.main;
      EXPECT_EQ(desk.settings, first);
    }
  }
}

}  // namespace
}  // namespace gbl::ui
