// The advisor in the window: its question, its answer, what Enter applies, and texts at every size.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

class AdvisorDesk : public Desk {
 public:
  explicit AdvisorDesk(ImVec2 display = {1600, 900}, bool present = false) : Desk(display, present) {
    input.size = {320, 180};
    advisor = &input;
    press("F7");
  }
  void answer() {
    const auto setup = [&](LightMethod method, NormalEncoding normal, int bytes) {
      AdvisedSetup a{settings, double(bytes), bytes, {{}, true, 2, {.compared = 57600, .over = 12, .worst = 0.004}}};
      a.settings.size = {320, 180};
      a.settings.camera.position = {1, 2, 3};  // must not be applied
      a.settings.lights.method = method;
      a.settings.lights.cull = LightCull::front;
      a.settings.normal.encoding = normal;
      return a;
    };
    input.advice.emplace();
    input.advice->best = setup(LightMethod::clustered, NormalEncoding::oct12, 17);
    input.advice->runner_up = setup(LightMethod::quads, NormalEncoding::xyz16f, 21);
    for (int k = 0; k < 30; ++k)
      input.advice->left_out.push_back(
          fmt::format("normal.encoding=xyz8-raw number {}: 12.3 % of the pixels are over the bound from camera 3, the "
                      "worst by 104 codes",
                      k));
  }
  AdvisorInput input;
};

TEST(AdvisorPanel, TheBudgetHasItsEnds) {
  AdvisorDesk desk;
  EXPECT_TRUE(desk.requests.advisor.open);
  EXPECT_DOUBLE_EQ(255 * desk.requests.advisor.budget.display_difference, 1);
  EXPECT_DOUBLE_EQ(desk.requests.advisor.budget.share_over, 0.001);
  for (int k = 0; k < 10; ++k) desk.press("]");
  EXPECT_DOUBLE_EQ(255 * desk.requests.advisor.budget.display_difference, 16);
  for (int k = 0; k < 20; ++k) desk.press("[");
  EXPECT_DOUBLE_EQ(255 * desk.requests.advisor.budget.display_difference, 0.125);
  desk.press("b");
  EXPECT_EQ(desk.requests.advisor.budget.share_over, 0);
  desk.press("b");
  EXPECT_GT(desk.requests.advisor.budget.share_over, 0);
  std::set<AdviceCost> costs;
  for (int k = 0; k < 3; ++k) {
    costs.insert(desk.requests.advisor.cost);
    desk.press("x");
  }
  EXPECT_EQ(costs.size(), 3u);
}

TEST(AdvisorPanel, ItsKeysAreItsOwnOnlyWhileItIsOpen) {
  AdvisorDesk desk;
  const Settings before = desk.settings;
  for (const char* key : {"[", "b", "x", "r", "PgDn", "Enter"}) desk.press(key);
  EXPECT_EQ(desk.settings, before);
  desk.press("Esc");
  EXPECT_FALSE(desk.requests.advisor.open);
  desk.press("[");
  EXPECT_NE(desk.settings, before) << "fewer lights, as ever";
}

TEST(AdvisorPanel, RLooksOnceAndStopsWhatRuns) {
  AdvisorDesk desk;
  desk.press("r");
  EXPECT_TRUE(desk.requests.advisor.run);
  desk.frame();
  EXPECT_FALSE(desk.requests.advisor.run);
  desk.input.running = true;
  desk.press("r");
  EXPECT_TRUE(desk.requests.advisor.stop);
  EXPECT_FALSE(desk.requests.advisor.run);
}

TEST(AdvisorPanel, EnterAppliesTheMethodAndNothingThatIsTrue) {
  AdvisorDesk desk;
  desk.answer();
  for (const bool runner_up : {false, true}) {
    const Settings before = desk.settings;
    desk.press("Enter", runner_up);
    const Settings& from = (runner_up ? desk.input.advice->runner_up : desk.input.advice->best)->settings;
    for (const Option& o : options())
      EXPECT_EQ(o.get(desk.settings), o.get(o.group == Group::method ? from : before)) << o.path;
    EXPECT_NE(desk.settings, before);
    EXPECT_EQ(desk.settings.size, before.size);
  }
}

TEST(AdvisorPanel, EnterWithoutAnAnswerChangesNothing) {
  AdvisorDesk desk;
  const Settings before = desk.settings;
  desk.press("Enter");
  desk.answer();
  desk.input.advice->runner_up.reset();
  desk.press("Enter", true);
  EXPECT_EQ(desk.settings, before);
}

TEST(AdvisorPanel, NoTextIsCutAtAnySizeOrScaleAndEverythingLeftOutIsReached) {
  for (const ImVec2 display : {ImVec2{1600, 900}, {1280, 720}, {2560, 1080}})
    for (const bool present : {false, true})
      for (const bool running : {false, true}) {
        AdvisorDesk desk(display, present);
        EXPECT_TRUE(desk.ui.cut_texts().empty()) << desk.ui.cut_texts().front();
        desk.answer();
        desk.input.running = running, desk.input.tried = 123;
        desk.input.progress =
            "lights.method=volumes-stencil layout=split-luminance normal.encoding=oct16-precise position.source=depth "
            "depth.format=d32f-reversed accumulation.format=r11g11b10f accumulation.targets=split";
        desk.input.note = "This answer is of another truth (lights.attenuation has changed). R asks again.";
        for (int k = 0; k < 30; ++k) {
          desk.press("PgDn");
          EXPECT_TRUE(desk.ui.cut_texts().empty())
              << display.x << (present ? " presenting: " : ": ") << desk.ui.cut_texts().front();
        }
      }
}

}  // namespace
}  // namespace gbl::ui
