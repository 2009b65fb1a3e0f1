// Panels change places by their titles, are locked in a look of their own, and closed sets are never typed.
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/options/settings_json.h"
#include "tests/ui/ui_desk.h"
#include "ui/closed_sets.h"

namespace gbl::ui {
namespace {

void drag(Desk& desk, ImVec2 from, ImVec2 to) {
  desk.point(from);
  desk.point(from, true);
  for (int k = 1; k <= 4; ++k)
    desk.point(
        {from.x + (to.x - from.x) * static_cast<float>(k) / 4, from.y + (to.y - from.y) * static_cast<float>(k) / 4},
        true);
  desk.point(to);
  desk.frame();
}

TEST(PanelPlaces, ATitleDraggedOntoAnotherPanelSwapsThem) {
  Desk desk;
  const Camera camera = desk.settings.camera;
  drag(desk, {830, 8}, {100, 500});  // albedo's title onto diffuse light
  ASSERT_EQ(desk.settings.view.panels.size(), 8u);
  EXPECT_EQ(desk.settings.view.panels[1].view, "diffuse-light");
  EXPECT_EQ(desk.settings.view.panels[5].view, "albedo");
  EXPECT_EQ(desk.settings.camera, camera) << "nothing else is dragged";
  drag(desk, {30, 458}, {900, 100});  // and back
  EXPECT_TRUE(desk.settings.view.panels.empty()) << "the usual places are none to remember";
  drag(desk, {830, 8}, {100, 700});
  EXPECT_TRUE(desk.settings.view.panels.empty()) << "no panel there";
  drag(desk, {30, 8}, {900, 100});  // the large one
  EXPECT_EQ(desk.settings.view.panels[0].view, "albedo");
  desk.press("z", false, true);
  EXPECT_TRUE(desk.settings.view.panels.empty()) << "it can be taken back";
}

TEST(PanelPlaces, ALockedPanelKeepsItsLookWhileTheViewIsLookedAtOtherwise) {
  Desk desk;
  desk.settings.view.main = "final";
  desk.settings.view.looks = {{"final", {.range = glm::dvec2(0, 0.25)}}};
  desk.press("k", false, true);
  ASSERT_EQ(desk.requests.locked.size(), 1u);
  EXPECT_EQ(text_of(desk.requests.locked[0]), "final:0..0.25");
  desk.settings.view.looks.clear();
  desk.frame();
  EXPECT_EQ(text_of(desk.requests.locked[0]), "final:0..0.25");
  EXPECT_FALSE(desk.requests.visible[static_cast<size_t>(View::lights_per_pixel)]) << "it took this one's place";
  desk.press("k", false, true);
  EXPECT_TRUE(desk.requests.locked.empty());
  EXPECT_TRUE(desk.settings.view.panels.empty());
}

// A figure and the session keep these settings: what is written must be read again.
TEST(PanelPlaces, StoredCodesAreLockedAsTheyAre) {
  Desk desk;
  desk.settings.view.main = "final";
  desk.press("u", false, true);
  desk.press("k", false, true);
  ASSERT_EQ(desk.requests.locked.size(), 1u);
  EXPECT_EQ(text_of(desk.requests.locked[0]), "final:raw");
  EXPECT_EQ(parse_settings(settings_text(desk.settings), "settings"), desk.settings);
}

TEST(PanelPlaces, AClickOnATitleChoosesAndALockedPanelIsNeverTheLargeOne) {
  Desk desk;
  desk.click({830, 8});
  EXPECT_EQ(desk.settings.view.main, "albedo");
  desk.press("k", false, true);
  desk.frame();
  const std::vector<LookOf> locked = desk.settings.view.panels;
  ASSERT_FALSE(locked.empty());
  drag(desk, {830, 458}, {300, 200});
  EXPECT_EQ(desk.settings.view.panels, locked);
  const Option& o = option("view.panels");
  EXPECT_THROW(o.set(desk.settings, OptionList{"depth:0..50"}, o), Error);
}

TEST(PanelPlaces, OneViewMayStandTwice) {
  Desk desk;
  desk.settings.view.panels = {parse_look("final", ""), parse_look("depth", ""), parse_look("depth:0..50:turbo", ""),
                               parse_look("final", "")};
  desk.frame();
  EXPECT_EQ(desk.requests.locked.size(), 2u);
  EXPECT_EQ(desk.visible(), 2);
}

TEST(ClosedSets, AreSteppedThroughByTheirLetterAndNeverTyped) {
  Desk desk;
  for (const char* path : {"mistakes", "view.main", "scene"}) {
    const Option& o = option(path);
    ASSERT_FALSE(closed_items(o).empty());
    int number = 0;
    const auto holds = [&](const std::vector<const Option*>& page) {
      return std::find(page.begin(), page.end(), &o) != page.end();
    };
    while (!holds(options_on_page(number))) ++number;
    const std::string letter = option_letter(options_on_page(number), o);
    desk.press("Home");
    for (int k = 0; k <= number; ++k) desk.press("o");
    const OptionValue before = o.get(desk.settings);
    std::string key = letter;
    key[0] = static_cast<char>(std::tolower(key[0]));
    desk.press(key);
    EXPECT_NE(o.get(desk.settings), before) << path;
    desk.press(key, true);
    EXPECT_EQ(o.get(desk.settings), before) << path << ": Shift goes back";
    desk.press("Esc");
  }
  EXPECT_TRUE(closed_items(option("ambient")).empty());
}

TEST(ClosedSets, OneThatIsSwitchedLeavesTheOthersStrength) {
  Desk desk;
  State state(desk.settings, false);
  const std::vector<Light> lights;
  const Input input{.scene = desk.scene, .lights = lights, .features = {}, .report = desk.report};
  Requests requests;
  std::vector<std::string> cut;
  ImDrawList list(ImGui::GetDrawListSharedData());
  FrameContext f{state, desk.settings, input, requests, {}, type_for(1), Painter(list, cut)};
  desk.settings.view.overlays = {{"footprint", 0.25}};
  toggle_closed(f, option("view.overlays"), "wire");
  ASSERT_EQ(desk.settings.view.overlays.size(), 2u);
  EXPECT_EQ(text_of(desk.settings.view.overlays[0]), "footprint:0.25");
  toggle_closed(f, option("view.overlays"), "footprint");
  ASSERT_EQ(desk.settings.view.overlays.size(), 1u);
  EXPECT_EQ(desk.settings.view.overlays[0].view, "wire");
}

}  // namespace
}  // namespace gbl::ui
