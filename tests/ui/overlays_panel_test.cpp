// Ctrl+V: letters lay views over the main one, sliders say how strongly.
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"
#include "ui/overlay_legends.h"

namespace gbl::ui {
namespace {

TEST(OverlaysPanel, ALetterLaysOnShiftStrengthensAndEndTakesAllAway) {
  Desk desk;
  desk.press("v", false, true);
  desk.press("c");
  ASSERT_EQ(desk.settings.view.overlays.size(), 1u);
  const std::string first = desk.settings.view.overlays[0].view;
  EXPECT_EQ(desk.settings.view.overlays[0].opacity, kOverlayOpacity);
  desk.press("c", true);
  EXPECT_EQ(desk.settings.view.overlays[0].opacity, 1);
  desk.press("c", true);
  EXPECT_EQ(desk.settings.view.overlays[0].opacity, 0.25) << "round again";
  desk.press("d");
  EXPECT_EQ(desk.settings.view.overlays.size(), 2u);
  EXPECT_EQ(desk.settings.view.overlays[0].view, first) << "the new one lies on top";
  desk.press("c");
  EXPECT_EQ(desk.settings.view.overlays.size(), 1u);
  desk.frame();
  desk.press("End");
  desk.frame();
  EXPECT_TRUE(desk.settings.view.overlays.empty());
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings.view.overlays.size(), 1u) << "as any change it can be taken back";
}

TEST(OverlaysPanel, TheMouseSwitchesAndSlides) {
  Desk desk;
  desk.press("v", false, true);
  desk.click({1300, 55});  // the first row's name
  ASSERT_EQ(desk.settings.view.overlays.size(), 1u);
  for (const auto& [x, down] : {std::pair(1580.0f, false), {1580.0f, true}, {1532.0f, true}, {1532.0f, false}})
    desk.point({x, 50}, down);
  ASSERT_EQ(desk.settings.view.overlays.size(), 1u);
  EXPECT_NEAR(desk.settings.view.overlays[0].opacity, 0.5, 0.1);
}

TEST(OverlaysPanel, LegendsNameEachAndSayWhatItMarks) {
  Desk desk;
  desk.settings.view.overlays = {{"footprint", 0.5}, {"tile-edges", 1}};
  ViewStats stats;
  stats.pixels = 200, stats.whole = {100, 50, 49, 1};
  EXPECT_EQ(marked_in_words(View::footprint, &stats), "covered, out of range 25 %, lit 24.5 %, missed 0.5 %");
  EXPECT_EQ(marked_in_words(View::footprint, nullptr), "");
  EXPECT_EQ(marked_in_words(View::wire, &stats), "50 % of the pixels");
  const std::vector<Light> lights;
  const Input in{.scene = desk.scene, .lights = lights, .features = desk.features, .report = desk.report};
  const std::vector<OverlayLegend> all = overlay_legends(View::final, desk.settings, in);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "tile edges 100 %") << "the topmost first";
  EXPECT_NE(all[0].words.find("neither tiles nor clusters"), std::string::npos);
  EXPECT_EQ(all[1].legend.entries.size(), std::size(kFootprintClasses) - 1) << "what it leaves alone has no colour";
  desk.settings.view.overlays = {{"error", 1}};
  EXPECT_NE(overlay_legends(View::final, desk.settings, in)[0].words.find("needs the reference"), std::string::npos);
  desk.settings.view.overlays = {{"footprint", 0.5}, {"tile-edges", 1}};
  EXPECT_TRUE(overlay_legends(View::footprint, desk.settings, in).size() == 1) << "none lies over itself";
}

}  // namespace
}  // namespace gbl::ui
