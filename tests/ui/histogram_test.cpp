// The histogram on the large picture, under the mouse and the keyboard.
#include "ui/histogram.h"

#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

// The first screen with the final picture's histogram open: numbers from 0 to 2.
class Histogram : public testing::Test {
 protected:
  void SetUp() override {
    stats.pixels = 1000;
    stats.min = glm::dvec3(0), stats.max = glm::dvec3(2), stats.binned = {0, 2};
    stats.bins[0][5] = 900, stats.bins[0][40] = 9;
    desk.stats[static_cast<size_t>(View::final)] = &stats;
    desk.press("h", false, true);
    desk.frame();
    boxes = histogram_boxes(make_layout({.display = {1600, 900}}).main_box(), type_for(1).small);
  }
  std::optional<glm::dvec2> range() const { return look_of(desk.settings.view.looks, "final").range; }
  // Where this number stands, on the handles' line.
  ImVec2 at(double number) const {
    return {boxes.plot.min.x + static_cast<float>(number / 2) * boxes.plot.width(), boxes.plot.max.y + 3};
  }
  void drag(ImVec2 from, ImVec2 to) {
    desk.point(from);
    desk.point(from, true);
    desk.point(to, true);
    desk.point(to);
  }
  void type(size_t field, const char* text) {
    const Box& b = boxes.fields[field];
    desk.click({(b.min.x + b.max.x) / 2, (b.min.y + b.max.y) / 2});
    desk.type(text);
  }

  ViewStats stats;
  Desk desk;
  HistogramBoxes boxes;
};

TEST_F(Histogram, HandlesMoveBlackAndWhiteAndADoubleClickPutsThemBack) {
  EXPECT_FALSE(range());
  drag(at(1), at(1.5));
  ASSERT_TRUE(range());
  EXPECT_EQ(range()->x, 0);
  EXPECT_NEAR(range()->y, 1.5, 0.02);
  drag(at(0), at(0.5));
  EXPECT_NEAR(range()->x, 0.5, 0.02);
  EXPECT_NEAR(range()->y, 1.5, 0.02);
  const ImVec2 bars{at(1).x, boxes.plot.min.y + 4};
  for (int k = 0; k < 60; ++k) desk.frame();  // longer than a double click takes
  const Camera camera = desk.settings.camera;
  drag(bars, at(1.9));
  EXPECT_NEAR(range()->y, 1.5, 0.02) << "a drag that begins elsewhere moves none";
  EXPECT_EQ(desk.settings.camera, camera) << "nor what lies below";
  for (int k = 0; k < 60; ++k) desk.frame();
  desk.click(bars);
  desk.click(bars);
  EXPECT_FALSE(range());
}

TEST_F(Histogram, NumbersCanBeTyped) {
  type(0, "-0.25");
  ASSERT_TRUE(range());
  EXPECT_EQ(*range(), glm::dvec2(-0.25, 1));
  type(1, "40");
  EXPECT_EQ(*range(), glm::dvec2(-0.25, 40)) << "beyond the axis, too";
  EXPECT_TRUE(desk.ui.cut_texts().empty()) << desk.ui.cut_texts()[0];
}

TEST_F(Histogram, WhatIsNoNumberChangesNothing) {
  for (const char* text : {"abc", "", "0x10", "1"}) {  // the last is white already
    type(0, text);
    EXPECT_FALSE(range()) << text;
  }
  type(0, "0.5");
  EXPECT_EQ(range(), glm::dvec2(0.5, 1)) << "what was refused can be typed over";
}

// Bars are as high as the logarithm of the count, or as the count.
TEST_F(Histogram, CountsAreLogarithmicOrLinear) {
  const auto highest_of_small_bar = [&] {
    const double left = 40 * 2.0 / ViewStats::kBins;
    const ImVec2 from = at(left);
    float top = boxes.plot.max.y;
    const ImDrawData* data = ImGui::GetDrawData();
    for (int l = 0; l < data->CmdListsCount; ++l)
      for (const ImDrawVert& v : data->CmdLists[l]->VtxBuffer)
        if (std::abs(v.pos.x - from.x) < 0.6f && v.pos.y > boxes.plot.min.y && v.pos.y < top) top = v.pos.y;
    return (boxes.plot.max.y - top) / boxes.plot.height();
  };
  EXPECT_NEAR(highest_of_small_bar(), std::log1p(9) / std::log1p(900), 0.03);
  desk.click({boxes.counts.min.x + 10, boxes.counts.min.y + 8});
  EXPECT_LT(highest_of_small_bar(), 0.1);
  desk.click({boxes.counts.min.x + 10, boxes.counts.min.y + 8});
  EXPECT_GT(highest_of_small_bar(), 0.2);
}

TEST_F(Histogram, TheCodesAreShownUntilSomethingElseIsAskedFor) {
  const auto look = [&] { return look_of(desk.settings.view.looks, "final"); };
  type(0, "0.5");
  desk.press("u", false, true);
  EXPECT_TRUE(look().raw);
  EXPECT_FALSE(look().range) << "codes have no black and white";
  desk.press("u", false, true);
  EXPECT_TRUE(look().plain());
  desk.press("u", false, true);
  drag(at(1), at(1.5));
  EXPECT_FALSE(look().raw);
  EXPECT_TRUE(look().range);
}

}  // namespace
}  // namespace gbl::ui
