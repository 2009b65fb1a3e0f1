// A and B from the keyboard and with the mouse.
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

TEST(Compare, TabGoesToTheStateBeforeTheLastChangeAndBack) {
  Desk desk;
  const LightCull was = desk.settings.lights.cull;
  desk.press("c");
  desk.frame();
  const LightCull now = desk.settings.lights.cull;
  ASSERT_NE(now, was);
  desk.press("Tab");
  EXPECT_EQ(desk.settings.lights.cull, was);
  desk.press("Tab");
  EXPECT_EQ(desk.settings.lights.cull, now);
  desk.press("Tab");
  desk.frame();
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings.lights.cull, was) << "to flip is no change that could be taken back";
}

TEST(Compare, WithoutAChangeTabKeepsTheStateAsB) {
  Desk desk;
  const Settings start = desk.settings;
  desk.press("Tab");
  EXPECT_EQ(desk.settings, start);
  desk.press("n");
  desk.press("Tab");
  EXPECT_EQ(desk.settings, start);
}

TEST(Compare, BothHaveOneCameraAndOneViewInOneScene) {
  Desk desk;
  desk.press("c");
  desk.frame();
  desk.press("Tab");
  desk.settings.camera.position.x += 10;
  desk.press("3");
  const Camera camera = desk.settings.camera;
  desk.press("Tab");
  EXPECT_EQ(desk.settings.camera, camera);
  EXPECT_EQ(desk.settings.view.main, "normal");
}

TEST(Compare, ItIsOfTheLargePictureWhicheverPanelIsChosen) {
  Desk desk;
  desk.press("c");
  desk.frame();
  desk.settings.view.main = "depth";  // as a click on a small panel of the mosaic does
  desk.press("/");
  ASSERT_TRUE(desk.requests.compare);
  ASSERT_EQ(desk.settings.view.main, "depth");
  EXPECT_EQ(desk.requests.compare->view, View::final);
  desk.press("4");  // large
  desk.frame();
  EXPECT_EQ(desk.requests.compare->view, View::depth);
}

TEST(Compare, SlashGoesThroughTheModesAndAsksForB) {
  Desk desk;
  desk.press("c");
  desk.frame();
  EXPECT_FALSE(desk.requests.compare);
  desk.press("/");
  ASSERT_TRUE(desk.requests.compare) << "wipe";
  EXPECT_NE(desk.requests.compare->b.lights.cull, desk.settings.lights.cull);
  EXPECT_FALSE(desk.requests.compare->difference);
  desk.press("/");
  EXPECT_TRUE(desk.requests.compare) << "side by side";
  desk.press("/");
  ASSERT_TRUE(desk.requests.compare);
  EXPECT_TRUE(desk.requests.compare->difference);
  EXPECT_EQ(desk.requests.compare->share, glm::dvec2(1));
  desk.settings.view.zoom = 4;
  desk.frame();
  EXPECT_EQ(desk.requests.compare->share, glm::dvec2(0.25)) << "the numbers are of what is seen";
  desk.press("/");
  EXPECT_FALSE(desk.requests.compare) << "off";
}

TEST(Compare, TheLineIsDraggedAndADoubleClickPutsItBack) {
  Desk desk;
  desk.press("c");
  desk.frame();
  desk.press("/");
  const Camera camera = desk.settings.camera;
  const auto line = [&] {  // where a drag takes it
    for (int x = 0; x < 800; x += 4) {
      desk.point({static_cast<float>(x), 225});
      if (ImGui::GetMouseCursor() == ImGuiMouseCursor_ResizeEW) return x;
    }
    return -1;
  };
  EXPECT_NEAR(line(), 392, 8);
  for (const auto& [x, down] :
       {std::pair(400.0f, false), {400.0f, true}, {300.0f, true}, {200.0f, true}, {200.0f, false}})
    desk.point({x, 225}, down);
  EXPECT_NEAR(line(), 192, 8);
  EXPECT_EQ(desk.settings.camera, camera) << "what lies below it does not move";
  EXPECT_FALSE(desk.ui.moving(desk.settings));
}

TEST(Compare, XTakesTheSoundChoicesAndGoesBack) {
  Desk desk;
  desk.press("c");  // flip -> back
  desk.frame();
  ASSERT_FALSE(sound(desk.settings));
  const Settings failing = desk.settings;
  desk.press("x");
  EXPECT_TRUE(sound(desk.settings));
  EXPECT_EQ(desk.settings, cured(failing));
  desk.press("x");
  EXPECT_EQ(desk.settings, failing);
}

TEST(Compare, ThePanelSetsB) {
  Desk desk;
  desk.press("c");
  desk.frame();
  desk.press("b", false, true);
  desk.press("t");
  ASSERT_TRUE(desk.requests.compare);
  EXPECT_EQ(desk.requests.compare->what, BesideA::truth);
  EXPECT_TRUE(desk.requests.visible[static_cast<size_t>(View::reference)]);
  desk.press("s");
  EXPECT_EQ(desk.requests.compare->what, BesideA::settings);
  EXPECT_TRUE(sound(desk.requests.compare->b));
  desk.press("h");
  EXPECT_EQ(desk.requests.compare->b.lights.cull, preset("start").make().lights.cull);
  desk.press("o");
  EXPECT_FALSE(desk.requests.compare);
}

}  // namespace
}  // namespace gbl::ui
