// Ctrl+O: typing, completing, choosing and opening; the answers of the app are written here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

class PathPanel : public testing::Test {
 protected:
  void SetUp() override {
    desk_.path = &answer_;
    desk_.press("o", false, true);
    desk_.frame(), desk_.frame();
  }
  // What the app does after every frame.
  void answer() {
    answer_.asked = desk_.requests.path.typed;
    answer_.completed = answer_.asked;
    answer_.matches.clear();
    answer_.folder = answer_.asked == "mo" || answer_.asked == "models/";
    if (answer_.asked == "m") answer_.completed = "mo", answer_.matches = {"models/", "moon.glb"};
    if (answer_.asked == "models/") answer_.matches = {"a.glb"};
  }
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    desk_.frame();
    answer();
    desk_.frame();
  }
  std::string typed() const { return desk_.requests.path.typed; }
  bool open() const { return desk_.ui.is_open("file.open"); }
  Desk desk_;
  PathInput answer_;
};

TEST_F(PathPanel, WhatIsTypedIsAskedForAndEnterOpensIt) {
  type("moon.glb");
  EXPECT_TRUE(desk_.requests.path.open);
  EXPECT_EQ(typed(), "moon.glb");
  EXPECT_EQ(desk_.requests.path.file, "");
  desk_.press("Enter");
  const std::string at_once = desk_.requests.path.file;
  desk_.frame();
  EXPECT_EQ(at_once + desk_.requests.path.file, "moon.glb") << "once";
  desk_.frame();
  EXPECT_EQ(desk_.requests.path.file, "");
  EXPECT_FALSE(open());
}

TEST_F(PathPanel, TabCompletesAlsoWhenTheAnswerComesLaterAndTypingGoesOnBehindIt) {
  ImGui::GetIO().AddInputCharactersUTF8("m");
  desk_.frame();
  desk_.press("Tab");
  EXPECT_EQ(typed(), "m") << "the answer is still to come";
  answer();
  desk_.frame(), desk_.frame();
  EXPECT_EQ(typed(), "mo");
  type("dels/");
  EXPECT_EQ(typed(), "models/");
  desk_.press("Tab");
  EXPECT_EQ(typed(), "models/") << "there is nothing more in common";
}

TEST_F(PathPanel, EnterOnAFolderGoesIntoIt) {
  answer_ = {.asked = "mo", .completed = "mo", .folder = true};
  ImGui::GetIO().AddInputCharactersUTF8("mo");
  desk_.frame(), desk_.frame();
  desk_.press("Enter");
  for (int i = 0; i < 4; ++i) desk_.frame();
  EXPECT_TRUE(open());
  EXPECT_EQ(typed(), "mo/");
  EXPECT_EQ(desk_.requests.path.file, "");
}

TEST_F(PathPanel, DownAndUpWalkWhatWasOpenedLately) {
  answer_.recent = {"/new.glb", "/old.png"};
  for (const auto& [key, text] : {std::pair("Down", "/new.glb"), std::pair("Down", "/old.png"),
                                  std::pair("Down", "/old.png"), std::pair("Up", "/new.glb")}) {
    desk_.press(key);
    desk_.frame();
    EXPECT_EQ(typed(), text);
  }
  desk_.press("Enter");
  desk_.frame();
  EXPECT_FALSE(open());
}

TEST_F(PathPanel, AMessageDoesNotTakeTheKeyboardAway) {
  type("moon");
  desk_.message = "shaders read again";
  desk_.frame(), desk_.frame();
  type(".glb");
  EXPECT_EQ(typed(), "moon.glb");
  EXPECT_TRUE(open());
}

TEST_F(PathPanel, EscClosesItAndNothingIsOpened) {
  const Settings before = desk_.settings;
  type("c");  // a key of the pictures, were it not typed here
  EXPECT_EQ(desk_.settings, before);
  desk_.press("Esc");
  desk_.frame();
  EXPECT_FALSE(open());
  EXPECT_EQ(desk_.requests.path.file, "");
}

// By the mouse: every line below the field is pressed, and says what it stands for.
TEST(PathPanelByMouse, LinesAreOpenedByAClick) {
  std::set<std::string> opened, entered;
  for (int line = 0; line < 50; ++line) {
    const float y = 8.0f * static_cast<float>(line);
    Desk desk;
    PathInput in{.matches = {"models/", "moon.glb"}, .recent = {"/r/recent.png"}};
    desk.path = &in;
    desk.press("o", false, true);
    desk.frame(), desk.frame();
    desk.point({800, y});
    desk.point({800, y}, true);
    std::string file = desk.requests.path.file;
    desk.point({800, y});
    file += desk.requests.path.file;
    for (int i = 0; i < 3; ++i) desk.frame();
    if (!file.empty()) opened.insert(file);
    if (desk.ui.is_open("file.open")) entered.insert(desk.requests.path.typed);
  }
  EXPECT_EQ(opened, (std::set<std::string>{"moon.glb", "/r/recent.png"}));
  EXPECT_TRUE(entered.count("models/")) << "a folder is gone into";
}

TEST_F(PathPanel, LongPathsAndManyOfThemFit) {
  answer_.recent.assign(10, fmt::format("/{:x>300}/ü/{:y>40}.glb", "", ""));
  answer_.matches.assign(500, fmt::format("{:w>250}.glb", ""));
  for (int i = 0; i < 4; ++i) desk_.frame();
  EXPECT_TRUE(desk_.ui.cut_texts().empty()) << desk_.ui.cut_texts().front();
}

}  // namespace
}  // namespace gbl::ui
