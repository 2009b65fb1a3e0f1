// Presenting: the picture alone, one caption, and no messages but errors.
#include "ui/presenting.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

bool message_is_shown() { return ImGui::GetForegroundDrawList()->VtxBuffer.Size > 0; }

TEST(Presenting, ThePictureFillsTheWindowAndTheKeyBringsEverythingBack) {
  Desk desk;
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(800, 450));
  desk.press("p", true, true);
  EXPECT_FALSE(desk.ui.is_open("pixel")) << "that is Ctrl+P";
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(1600, 900));
  EXPECT_EQ(desk.visible(), 1);
  desk.press("0");
  EXPECT_EQ(desk.visible(), 8) << "all views, without what stands around them";
  desk.press("p", true, true);
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(800, 450));
  EXPECT_EQ(desk.visible(), 8);
}

TEST(Presenting, NoButtonsStandOnThePicture) {
  for (const bool present : {true, false}) {
    Desk desk({1600, 900}, present);
    desk.press("2");
    const float right = static_cast<float>(desk.requests.picture_size.x);
    for (float x = right - 10; x > right - 500; x -= 6) desk.click({x, 16});
    EXPECT_EQ(desk.settings.view.looks.empty() && desk.settings.view.zoom == 1, present);
  }
}

TEST(Presenting, HomeStaysThere) {
  Desk desk({1600, 900}, true);
  EXPECT_EQ(desk.visible(), 1);
  desk.press("4");
  desk.press("Home");
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(1600, 900));
  EXPECT_EQ(desk.settings.view.main, "final");
}

TEST(Presenting, ErrorsAreShownAndOtherMessagesAreNot) {
  for (const bool present : {false, true})
    for (const bool error : {false, true}) {
      Desk desk({1600, 900}, present);
      desk.message = "something happened";
      desk.message_is_error = error;
      desk.frame();
      EXPECT_EQ(message_is_shown(), error || !present) << (present ? "presenting, " : "") << (error ? "an error" : "");
    }
}

// What stands at the picture's lower edge stands above the caption.
TEST(Presenting, TheCaptionLeavesTheLegendsTheirPlace) {
  Desk desk({1600, 900}, true);
  State state(desk.settings, true);
  const std::vector<Light> lights;
  const Input input{.scene = desk.scene, .lights = lights, .features = {}, .report = desk.report};
  Requests requests;
  std::vector<std::string> cut;
  ImDrawList list(ImGui::GetDrawListSharedData());
  FrameContext f{state, desk.settings, input, requests, {}, type_for(1.5f), Painter(list, cut)};
  f.layout = make_layout({.display = {1600, 900}, .large = true, .present = true, .status_height = 0});
  EXPECT_GT(presenting_foot(f), line_height(f.type.large));
  EXPECT_LT(presenting_foot(f), 0.3f * 900 + 1);
  f.layout = make_layout({.display = {1600, 1400}, .large = true, .present = true, .status_height = 0});
  EXPECT_EQ(presenting_foot(f), 0) << "there is room below the picture";
  state.hidden = true;
  f.layout = make_layout({.display = {1600, 900}, .large = true, .present = true, .status_height = 0});
  EXPECT_EQ(presenting_foot(f), 0);
}

}  // namespace
}  // namespace gbl::ui
