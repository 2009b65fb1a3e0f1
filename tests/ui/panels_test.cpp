// Every row of the panels table: opened, closed, and listed with its keys.
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"
#include "ui/key_spec.h"

namespace gbl::ui {
namespace {

KeyRow key_row_of(const Panel& p) {
  for (const KeyRow& row : key_rows())
    if (row.id == p.id) return row;
  ADD_FAILURE() << p.id << " is not in the list of keys";
  return {};
}

std::set<std::string> open_panels(const Desk& desk) {
  std::set<std::string> open;
  for (const Panel* p : panels())
    if (desk.ui.is_open(p->id)) open.insert(p->id);
  return open;
}

TEST(Panels, EachOpensByItsKeyAndEscClosesIt) {
  for (const Panel* p : panels())
    for (const KeyEvent& key : presses_of(key_row_of(*p))) {
      Desk desk;
      desk.frame({key});
      EXPECT_EQ(open_panels(desk), std::set<std::string>{p->id}) << key.key;
      desk.frame();
      desk.press("Esc");
      EXPECT_TRUE(open_panels(desk).empty()) << p->id;
    }
}

// ImGui stops the program for a button without an area: none may be asked for, whatever the window's shape.
TEST(Panels, EachLivesInAWindowOfAnySize) {
  constexpr float kSides[] = {1, 2, 4, 10, 90, 100, 161, 240, 400, 900, 1600};
  for (const Panel* p : panels())
    for (const bool present : {false, true}) {
      Desk desk({1600, 900}, present);
      desk.frame({presses_of(key_row_of(*p)).front()});
      for (const float width : kSides)
        for (const float height : kSides) {
          ImGui::GetIO().DisplaySize = {width, height};
          desk.frame();
          desk.frame();
        }
      ImGui::GetIO().DisplaySize = {1600, 900};
      desk.frame();
      EXPECT_TRUE(desk.ui.is_open(p->id)) << p->id;
    }
}

TEST(Panels, EachHasItsKeysInTheListOfKeys) {
  for (const Panel* p : panels()) {
    const KeyRow row = key_row_of(*p);
    EXPECT_EQ(row.key, p->key);
    for (const PanelKey& k : p->keys) {
      if (!k.run) continue;
      EXPECT_NE(row.help.find(printed_keys(k.key) + " " + k.words), std::string::npos) << p->id << ": " << k.key;
    }
  }
}

TEST(Panels, AKeyThatAPanelOnlyPrintsIsItsOwn) {
  for (const Panel* p : panels())
    for (const PanelKey& k : p->keys) {
      if (k.run) continue;
      EXPECT_STREQ(k.key, p->key);
    }
}

TEST(Panels, NoKeyOfAnOpenPanelIsInTwoOfItsRows) {
  for (const Panel* p : panels()) {
    std::set<std::string> seen;
    for (const PanelKey& k : p->keys)
      for (const std::string& key : key_spec(k.key).keys) EXPECT_TRUE(seen.insert(key).second) << p->id << ": " << key;
  }
}

TEST(Panels, OneStandsBesideThePicturesAtATime) {
  Desk desk;
  for (const Panel* p : panels()) {
    if (p->place != Place::beside) continue;
    desk.frame(presses_of(key_row_of(*p)));
    EXPECT_EQ(open_panels(desk), std::set<std::string>{p->id});
  }
}

TEST(Panels, EscClosesThemFromTheTopmostDown) {
  Desk desk;
  for (const char* key : {"h", "F4", "F1", "o"}) desk.press(key);
  for (const char* id : {"options", "help", "stability", "card"}) {
    EXPECT_TRUE(desk.ui.is_open(id)) << id;
    desk.press("Esc");
    EXPECT_FALSE(desk.ui.is_open(id)) << id;
  }
}

TEST(Panels, HomeAndALessonLeaveWhatStandsBesideThePictures) {
  Desk desk;
  for (const char* key : {"h", "F3", "F1", "o"}) desk.press(key);
  desk.press("Home");
  EXPECT_EQ(open_panels(desk), (std::set<std::string>{"chart", "options"}));
  for (const char* key : {"h", "F1"}) desk.press(key);
  desk.ui.open_lesson(lesson_ids().front(), desk.settings);
  EXPECT_EQ(open_panels(desk), std::set<std::string>{"chart"});
}

TEST(Panels, OneThatIsNotOnScreenHidesNoPicture) {
  Desk desk;
  desk.press("o");
  const int beside_options = desk.visible();
  desk.press("Esc");
  desk.press("h");
  EXPECT_LT(desk.visible(), 8) << "below the card";
  desk.press("o");
  EXPECT_EQ(desk.visible(), beside_options) << "the card makes way for the options";
}

TEST(Panels, EnterMayComeBeforeItsFieldHasTheKeyboard) {
  Desk desk;
  desk.frame({KeyEvent{"g", false, true, false}, KeyEvent{"Enter"}});
  for (int k = 0; k < 3; ++k) desk.frame();
  EXPECT_FALSE(desk.ui.is_open("pixel.go-to"));
  EXPECT_EQ(desk.requests.probe, desk.settings.size / 2) << "the field's text, as it was offered";
  desk.press("Right");
  EXPECT_EQ(desk.requests.probe, desk.settings.size / 2 + glm::ivec2(1, 0)) << "and keys are the window's again";
}

TEST(Panels, TheTypedPixelsDialogGoesWhenItsFieldIsLeft) {
  Desk desk;
  desk.press("g", false, true);
  for (int k = 0; k < 3; ++k) desk.frame();
  EXPECT_TRUE(desk.ui.is_open("pixel.go-to"));
  desk.press("c");
  EXPECT_EQ(desk.settings.lights.cull, LightCull::flip) << "the letter is typed";
  desk.click({30, 400});
  EXPECT_FALSE(desk.ui.is_open("pixel.go-to"));
  desk.press("c");
  EXPECT_EQ(desk.settings.lights.cull, LightCull::back);
}

TEST(KeySpecs, OneMatcherReadsEveryWayToWriteKeys) {
  const auto which = [](const char* spec, KeyEvent e) { return which_key(key_spec(spec), e); };
  EXPECT_EQ(which("C", {"c"}), 0u);
  EXPECT_EQ(which("C", {"c", true}), 0u) << "Shift is free";
  EXPECT_FALSE(which("C", {"c", false, true})) << "Ctrl is not";
  EXPECT_EQ(which("Ctrl+G", {"g", false, true}), 0u);
  EXPECT_FALSE(which("Ctrl+G", {"g"}));
  EXPECT_EQ(which("Shift , .", {".", true}), 1u);
  EXPECT_FALSE(which("Shift , .", {"."}));
  EXPECT_EQ(which("+ -", {"="}), 0u);
  EXPECT_EQ(which("+ -", {"_", true}), 1u);
  EXPECT_EQ(which("1-8", {"8"}), 7u);
  EXPECT_FALSE(which("1-8", {"9"}));
  EXPECT_FALSE(which("1-8", {"-"}));
  EXPECT_EQ(which("PgUp PgDn", {"PgDn"}), 1u);
  EXPECT_FALSE(which("", {""}));
  EXPECT_EQ(as_in_table(key_spec("+ -"), 0, {"=", true}).key, "+");
  EXPECT_EQ(printed_keys("Left Right 1-8"), "← → 1-8");
}

}  // namespace
}  // namespace gbl::ui
