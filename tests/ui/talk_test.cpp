// The ring that points and the timer with the lesson's steps.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "renderer/lessons/lessons.h"
#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

const ImVec2 kOnAPicture{300, 200}, kOnTheControls{1400, 600};

// Does a ring lie above everything about this place?
bool ring_at(ImVec2 at) {
  for (const ImDrawVert& v : ImGui::GetForegroundDrawList()->VtxBuffer)
    if (std::abs(v.pos.x - at.x) < 60 && std::abs(v.pos.y - at.y) < 60) return true;
  return false;
}

TEST(Reticle, FollowsTheMouseOnPicturesInTheCursorsPlace) {
  Desk desk;
  desk.point(kOnAPicture);
  desk.point(kOnAPicture);
  EXPECT_FALSE(ring_at(kOnAPicture));
  EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_Arrow);
  desk.press("F9");
  EXPECT_TRUE(ring_at(kOnAPicture));
  EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_None);
  desk.point(kOnTheControls);
  desk.point(kOnTheControls);
  EXPECT_FALSE(ring_at(kOnTheControls)) << "the cursor is needed there";
  EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_Arrow);
  desk.point(kOnAPicture);
  desk.press("F9");
  EXPECT_FALSE(ring_at(kOnAPicture));
}

TEST(TalkTimer, WakesTheWindowAtEachFullSecond) {
  Desk desk;
  desk.seconds = 10.25;
  desk.press("F10");
  ASSERT_TRUE(desk.requests.wake_in);
  EXPECT_NEAR(*desk.requests.wake_in, 1, 1e-9);
  desk.seconds = 75.5;
  desk.frame();
  EXPECT_NEAR(*desk.requests.wake_in, 0.75, 1e-9);
  desk.press("F10");
  EXPECT_FALSE(desk.requests.wake_in);
}

TEST(TalkTimer, TheStepsOfEveryLessonFit) {
  for (const ImVec2 display : {ImVec2{1600, 900}, {1280, 720}, {1366, 768}, {1600, 1200}})
    for (const bool present : {false, true})
      for (const std::string& id : lesson_ids()) {
        Desk desk(display, present);
        desk.ui.open_lesson(id, desk.settings);
        desk.press("F10");
        for (size_t step = 0; step < load_lesson(id).steps.size(); ++step, desk.press("PgDn"))
          EXPECT_TRUE(desk.ui.cut_texts().empty())
              << id << " at " << display.x << (present ? " presenting: " : ": ") << desk.ui.cut_texts().front();
      }
}

}  // namespace
}  // namespace gbl::ui
