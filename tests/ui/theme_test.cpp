// Both themes are legible, by the contrast ratio of WCAG 2.1 (https://www.w3.org/TR/WCAG21/#dfn-contrast-ratio).
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

double linear(float coded) {
  return coded <= 0.04045f ? coded / 12.92 : std::pow((double(coded) + 0.055) / 1.055, 2.4);
}

double luminance(ImU32 colour) {
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
  return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

double contrast(ImU32 a, ImU32 b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

ImU32 over(ImU32 veil, ImU32 ground) {
  const ImVec4 v = ImGui::ColorConvertU32ToFloat4(veil), g = ImGui::ColorConvertU32ToFloat4(ground);
  const auto mixed = [&](float top, float below) { return below + (top - below) * v.w; };
  return ImGui::ColorConvertFloat4ToU32({mixed(v.x, g.x), mixed(v.y, g.y), mixed(v.z, g.z), 1});
}

struct Named {
  const char* name;
  ImU32 colour;
};

void expect_contrast(const Theme& t, const std::vector<Named>& inks, const std::vector<Named>& grounds, double least) {
  for (const Named& ink : inks)
    for (const Named& ground : grounds)
      EXPECT_GE(contrast(ink.colour, ground.colour), least) << t.name << ": " << ink.name << " on " << ground.name;
}

class Themes : public testing::TestWithParam<const Theme*> {};

TEST_P(Themes, EveryTextHasAContrastOfSevenOnWhatItStandsOn) {
  const Theme& t = *GetParam();
  const std::vector<Named> rooms = {{"background", t.background}, {"surface", t.surface}, {"raised", t.raised}};
  const std::vector<Named> widgets = {{"hovered", t.hovered}, {"pressed", t.pressed}};
  const std::vector<Named> pictures = {{"backing on white", over(t.backing, IM_COL32_WHITE)},
                                       {"backing on black", over(t.backing, IM_COL32_BLACK)}};
  const std::vector<Named> words = {{"text", t.text}, {"accent", t.accent}, {"unsound", t.unsound}};
  expect_contrast(t, words, rooms, 7);
  expect_contrast(t, words, widgets, 7);
  expect_contrast(t, words, pictures, 7);
  expect_contrast(t, {{"dim", t.dim}}, rooms, 7);
  expect_contrast(t, {{"dim", t.dim}}, pictures, 7);
  expect_contrast(t, {{"text", t.text}}, {{"wrong", t.wrong}, {"selection", t.selection}}, 7);
  expect_contrast(t, {{"background", t.background}}, {{"accent", t.accent}}, 7);  // a slider's number
  for (const ImU32 pass : t.passes) expect_contrast(t, {{"a pass", pass}}, {rooms[0], rooms[1]}, 7);
}

// Marks and lines of a plot are no text: 3:1 (WCAG 2.1, 1.4.11).
TEST_P(Themes, MarksStandOut) {
  const Theme& t = *GetParam();
  for (const ImU32 series : t.series)
    expect_contrast(t, {{"a series", series}}, {{"background", t.background}, {"edge", t.edge}}, 3);
}

INSTANTIATE_TEST_SUITE_P(Both, Themes, testing::Values(&kDarkTheme, &kLightTheme),
                         [](const auto& each) { return std::string(each.param->name); });

TEST(Theme, CtrlTSwitchesItAndFiguresFollowUntilToldOtherwise) {
  Desk desk;
  const auto figure_is_white = [&] {
    desk.press("F12");
    return desk.requests.figure && desk.requests.figure->white;
  };
  EXPECT_EQ(&theme(), &kDarkTheme);
  EXPECT_FALSE(figure_is_white());
  desk.press("t", false, true);
  EXPECT_EQ(&theme(), &kLightTheme);
  EXPECT_EQ(ImGui::ColorConvertFloat4ToU32(ImGui::GetStyle().Colors[ImGuiCol_Text]), kLightTheme.text);
  EXPECT_TRUE(figure_is_white());
  desk.press("F12", false, true);  // dark, whatever the theme
  EXPECT_FALSE(figure_is_white());
  desk.press("t", false, true);
  desk.press("t", false, true);
  EXPECT_FALSE(figure_is_white());
  EXPECT_TRUE(desk.ui.cut_texts().empty());
}

}  // namespace
}  // namespace gbl::ui
