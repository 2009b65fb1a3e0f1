// The pitfalls in the window: the list, an entry broken and fixed, and what was there before it.
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

class PitfallDesk : public Desk {
 public:
  using Desk::Desk;
  const PitfallEntry entry = load_pitfall("no-culling-doubles");
  void open() { ui.open_pitfall(entry.id, settings), frame(); }
  Settings side(PitfallSide s) const {
    Settings out = settings_of(entry, s);
    out.size = settings.size;
    return out;
  }
};

TEST(PitfallsPanel, EnterOpensTheChosenOneBrokenAndPClosesItAsItWas) {
  Desk desk;
  const Settings before = desk.settings;
  desk.press("p");
  EXPECT_TRUE(desk.ui.is_open("pitfalls"));
  EXPECT_EQ(desk.settings, before) << "a list changes nothing";
  desk.press("Enter");
  // The first screen's culling is unsound: its pitfall was chosen.
  Settings broken = settings_of(load_pitfall("near-plane-cut"), PitfallSide::broken);
  broken.size = desk.settings.size;
  EXPECT_EQ(desk.settings, broken);
  desk.frame();
  EXPECT_EQ(desk.requests.pitfall.id, "near-plane-cut");
  desk.press("p");
  desk.frame();
  EXPECT_EQ(desk.settings, before);
  EXPECT_EQ(desk.requests.pitfall.id, "");
}

TEST(PitfallsPanel, XGoesRoundBrokenFixedReferenceAndDifference) {
  PitfallDesk desk;
  desk.open();
  EXPECT_EQ(desk.settings, desk.side(PitfallSide::broken));
  desk.press("x");
  EXPECT_EQ(desk.settings, desk.side(PitfallSide::fixed));
  desk.press("x");
  EXPECT_EQ(desk.settings.view.main, "reference");
  desk.press("x");
  EXPECT_EQ(desk.settings, desk.side(PitfallSide::broken));
  desk.frame();
  ASSERT_TRUE(desk.requests.compare);
  EXPECT_TRUE(desk.requests.compare->difference);
  EXPECT_EQ(desk.requests.compare->b.lights.cull, desk.side(PitfallSide::fixed).lights.cull);
  desk.press("x");
  EXPECT_EQ(desk.settings, desk.side(PitfallSide::broken));
  EXPECT_FALSE(desk.requests.compare);
  desk.press("x", true);
  EXPECT_TRUE(desk.requests.compare) << "Shift goes the other way round";
}

TEST(PitfallsPanel, TheCameraStaysWhereItWasMovedTo) {
  PitfallDesk desk;
  desk.open();
  desk.settings.camera.position.y += 50;
  const Camera moved = desk.settings.camera;
  desk.press("x");
  EXPECT_EQ(desk.settings.camera, moved);
  desk.press("w");
  EXPECT_EQ(desk.settings.camera, desk.side(PitfallSide::blind).camera) << "where it hides is a place of its own";
}

TEST(PitfallsPanel, SpacePlaysThePathAndArrowsStepOnIt) {
  PitfallDesk desk;
  desk.open();
  desk.press("Space");
  EXPECT_EQ(desk.settings.camera, camera_on_path(desk.entry, 0));
  EXPECT_TRUE(desk.ui.moving(desk.settings));
  for (int i = 0; i < 40; ++i) desk.seconds += 0.25, desk.frame();
  EXPECT_EQ(desk.settings.camera, camera_on_path(desk.entry, 1));
  EXPECT_FALSE(desk.ui.moving(desk.settings));
  desk.press("Left");
  const Camera step = desk.settings.camera;
  EXPECT_NE(step, camera_on_path(desk.entry, 1));
  desk.press("x");
  EXPECT_EQ(desk.settings.camera, step) << "both sides are seen from one place";
  desk.press("Right");
  EXPECT_EQ(desk.settings.camera, camera_on_path(desk.entry, 1));
}

TEST(PitfallsPanel, TheNextOneOpensAndTheListIsAKeyAway) {
  PitfallDesk desk;
  const Settings before = desk.settings;
  desk.open();
  desk.press("PgDn");
  EXPECT_EQ(desk.requests.pitfall.id, "near-plane-cut");
  desk.press("l");
  EXPECT_EQ(desk.settings, before);
  EXPECT_TRUE(desk.ui.is_open("pitfalls"));
}

TEST(PitfallsPanel, WhatIsTypedFindsEntries) {
  Desk desk;
  desk.press("p");
  desk.press("f");
  desk.frame();
  desk.type("stereographic");
  desk.press("Enter");
  desk.frame();
  EXPECT_EQ(desk.requests.pitfall.id, "stereographic-pole");
}

TEST(PitfallsPanel, PicturesAreAskedForWhileTheListIsOpen) {
  Desk desk;
  desk.frame();
  EXPECT_FALSE(desk.requests.pitfall.list);
  desk.press("p"), desk.frame();
  EXPECT_TRUE(desk.requests.pitfall.list);
  desk.press("Enter"), desk.frame();
  EXPECT_FALSE(desk.requests.pitfall.list) << "an entry is open";
  desk.press("l"), desk.frame();
  EXPECT_TRUE(desk.requests.pitfall.list);
}

TEST(PitfallsPanel, EscLeavesAnEntryAsPDoes) {
  PitfallDesk desk;
  const Settings before = desk.settings;
  desk.open();
  desk.press("Esc");
  desk.frame();
  EXPECT_EQ(desk.settings, before);
  EXPECT_FALSE(desk.ui.is_open("pitfalls"));
}

TEST(PitfallsPanel, WhilePresentingItStandsBesideThePicture) {
  PitfallDesk desk({1600, 900}, true);
  desk.frame();
  const glm::ivec2 whole = desk.requests.picture_size;
  desk.open();
  desk.frame();
  EXPECT_EQ(desk.requests.picture_size.x, whole.x / 2);
}

TEST(PitfallsPanel, TheReferenceIsOfTheModelThatIsMeant) {
  PitfallDesk desk;
  desk.ui.open_pitfall("no-srgb", desk.settings);
  desk.press("x"), desk.press("x");
  EXPECT_EQ(desk.settings.view.main, "reference");
  EXPECT_EQ(desk.settings.colour, Colour::srgb);
}

TEST(PitfallsPanel, WhatTheDeviceCannotDrawIsSaidAndWhatIsShownStays) {
  PitfallDesk desk;  // without clip control
  desk.ui.open_pitfall("d32f-not-reversed", desk.settings);
  const Settings broken = desk.settings;
  desk.press("x");
  EXPECT_EQ(desk.settings, broken);
}

TEST(PitfallsPanel, UndoDoesNotBringAPitfallBack) {
  PitfallDesk desk;
  desk.press("c");
  desk.frame();
  const Settings before = desk.settings;
  desk.open();
  desk.frame();
  desk.press("p");
  desk.frame();
  EXPECT_EQ(desk.settings, before);
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings.scene, before.scene);
  EXPECT_EQ(desk.settings.camera, before.camera);
  EXPECT_NE(desk.settings, before) << "the change before it is taken back";
}

TEST(PitfallsPanel, AnUnknownOneIsRefused) {
  Desk desk;
  EXPECT_THROW(desk.ui.open_pitfall("near-plane", desk.settings), Error);
}

// Every entry, question and answer, in the common window, and in the smallest type and the largest.
TEST(PitfallsPanel, NoTextIsCut) {
  const auto expect_whole = [](ImVec2 display, bool present, size_t every) {
    PitfallDesk desk(display, present);
    const std::vector<PitfallEntry> all = load_pitfalls();
    for (size_t i = 0; i < all.size(); i += every) {
      desk.ui.open_pitfall(all[i].id, desk.settings);
      desk.frame();
      EXPECT_EQ(desk.ui.cut_texts(), std::vector<std::string>{}) << all[i].id << ", question at " << display.x;
      desk.press("Enter");
      EXPECT_EQ(desk.ui.cut_texts(), std::vector<std::string>{}) << all[i].id << ", answer at " << display.x;
    }
    desk.press("l");
    EXPECT_EQ(desk.ui.cut_texts(), std::vector<std::string>{}) << "list at " << display.x;
  };
  expect_whole({1600, 900}, false, 1);
  expect_whole({1280, 720}, true, 6);
  expect_whole({2560, 1440}, false, 12);
}

}  // namespace
}  // namespace gbl::ui
