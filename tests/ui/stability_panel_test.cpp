// The stability panel in the window: its keys, its curves and statements, and texts at every size.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

#include "tests/ui/ui_desk.h"
#include "ui/panels/stability_view.h"

namespace gbl::ui {
namespace {

DeviceLimits everything() {
  DeviceLimits limits;
  for (const FeatureRow& r : kFeatures) limits.features.add(r.feature);
  return limits;
}

// A sweep with made-up values: curve by curve larger, the first 0 throughout.
class SweepDesk : public Desk {
 public:
  explicit SweepDesk(ImVec2 display = {1600, 900}, bool present = false) : Desk(display, present) {
    stability = &input;
    press("F4");
  }
  // What the app does with the request, without measuring.
  void measure(const Sweep& s, bool complete = true) {
    runner.emplace(s, SweepRun{.limits = everything()});
    input = {};
    for (const Curve& c : runner->curves()) {
      input.stated.emplace_back();
      for (const Expected& e : c.expected) input.stated.back().push_back(text_of(e, words_of(s)));
    }
    size_t n = 0;
    while (!runner->complete() && (complete || n < runner->total() / 2)) {
      Measured m;
      const double v = n % runner->curves().size() == 0 ? 0 : std::pow(10.0, double(n % 7) - 4);
      for (const ErrorColumn& c : error_columns())
        m.errors.*c.value = n == 5 ? std::numeric_limits<double>::infinity() : v;
      runner->add(m);
      ++n;
    }
    input.result = &runner->result();
    input.done = runner->done(), input.total = runner->total();
    input.running = !complete;
  }
  // Everything that is drawn, as one number.
  size_t drawn() {
    frame();
    size_t h = 0;
    const ImDrawData* data = ImGui::GetDrawData();
    for (int l = 0; l < data->CmdListsCount; ++l)
      for (const ImDrawVert& v : data->CmdLists[l]->VtxBuffer)
        for (const float x : {v.pos.x, v.pos.y, v.uv.x, v.uv.y, static_cast<float>(v.col)})
          h ^= std::hash<float>()(x) + 0x9e3779b97f4a7c15u + (h << 6) + (h >> 2);
    return h;
  }
  std::optional<SweepRunner> runner;
  StabilityInput input;
};

// Of a column, and not of the truth, which these rows do not have.
std::vector<const Sweep*> sweeps_of_columns() {
  std::vector<const Sweep*> out;
  for (const Sweep& s : sweeps())
    if (!sweep_metric(s.metric).value) out.push_back(&s);
  return out;
}

void choose(SweepDesk& desk, const Sweep& s) {
  for (size_t k = 0; k < sweeps().size() && desk.requests.stability.sweep != s.id; ++k) desk.press("s");
  ASSERT_EQ(desk.requests.stability.sweep, s.id);
}

TEST(StabilityPanel, OneOfTheThreeIsOpenAndEscCloses) {
  SweepDesk desk;
  EXPECT_TRUE(desk.requests.stability.open);
  desk.press("F3");
  EXPECT_TRUE(desk.requests.chart.open);
  EXPECT_FALSE(desk.requests.stability.open);
  desk.press("F7");
  EXPECT_TRUE(desk.requests.advisor.open);
  EXPECT_FALSE(desk.requests.chart.open);
  desk.press("F4");
  EXPECT_TRUE(desk.requests.stability.open);
  EXPECT_FALSE(desk.requests.advisor.open);
  desk.press("F4");
  EXPECT_FALSE(desk.requests.stability.open);
  desk.press("F4");
  desk.press("Esc");
  EXPECT_FALSE(desk.requests.stability.open);
}

TEST(StabilityPanel, SGoesThroughAllSweepsAndBack) {
  SweepDesk desk;
  std::set<std::string> seen;
  for (size_t k = 0; k < sweeps().size(); ++k) {
    seen.insert(desk.requests.stability.sweep);
    desk.press("s");
  }
  EXPECT_EQ(seen.size(), sweeps().size());
  EXPECT_EQ(desk.requests.stability.sweep, sweeps()[0].id);
  desk.press("s", true);
  EXPECT_EQ(desk.requests.stability.sweep, sweeps().back().id);
}

TEST(StabilityPanel, RRunsOnceAndStopsWhatRuns) {
  SweepDesk desk;
  const Sweep& s = *sweeps_of_columns()[0];
  choose(desk, s);
  desk.press("r");
  EXPECT_TRUE(desk.requests.stability.run);
  desk.frame();
  EXPECT_FALSE(desk.requests.stability.run);
  desk.measure(s, false);
  desk.press("r");
  EXPECT_TRUE(desk.requests.stability.stop);
  EXPECT_FALSE(desk.requests.stability.run);
}

TEST(StabilityPanel, NoTextIsCutAtAnySizeOrScale) {
  for (const ImVec2 display : {ImVec2{1600, 900}, {1280, 720}, {2560, 1080}})
    for (const bool present : {false, true})
      for (const Sweep& s : sweeps()) {
        SweepDesk desk(display, present);
        choose(desk, s);
        EXPECT_TRUE(desk.ui.cut_texts().empty()) << s.id << ": " << desk.ui.cut_texts().front();
        if (sweep_metric(s.metric).value) continue;
        for (const bool complete : {false, true}) {
          desk.measure(s, complete);
          desk.input.note = "Stopped after 123 of 4567 points. R goes on.";
          for (size_t c = 0; c < desk.runner->curves().size(); ++c) {
            desk.press("Down");
            EXPECT_TRUE(desk.ui.cut_texts().empty())
                << s.id << " at " << display.x << (present ? " presenting: " : ": ") << desk.ui.cut_texts().front();
          }
        }
      }
}

TEST(StabilityPanel, EveryKeyIsSeenAndChangesNoSetting) {
  const std::pair<const char*, bool> keys[] = {{"s", false}, {"s", true},  {"Down", false}, {"Up", false},
                                               {"1", false}, {"2", false}, {"l", false}};
  for (const auto& [key, shift] : keys) {
    SweepDesk desk;
    const Sweep& s = sweep("view-distance");
    choose(desk, s);
    desk.measure(s);
    const Settings settings = desk.settings;
    desk.seconds += 10;
    const size_t before = desk.drawn();
    EXPECT_EQ(desk.drawn(), before) << "nothing moves by itself";
    desk.press(key, shift);
    desk.seconds += 10;
    EXPECT_NE(desk.drawn(), before) << key;
    EXPECT_EQ(desk.settings, settings) << key;
  }
}

struct Model {
  explicit Model(const StabilityInput& rows, const Sweep& s)
      : state({}, false),
        input{.scene = scene, .lights = lights, .features = {}, .report = report},
        frame{state, settings, input, requests, {}, {}, Painter(*ImGui::GetBackgroundDrawList(), state.cut_texts)} {
    input.stability = &rows;
    while (sweeps()[state.of<StabilityState>().sweep].id != std::string_view(s.id)) ++state.of<StabilityState>().sweep;
  }
  Scene scene;
  std::vector<Light> lights;
  FrameReport report;
  Settings settings;
  Requests requests;
  State state;
  Input input;
  FrameContext frame;
};

TEST(StabilityViews, TheSelectedCurvesStatementsComeFirstThenThoseThatFail) {
  SweepDesk desk;
  const Sweep& s = sweep("view-distance");
  desk.measure(s);
  Model m(desk.input, s);
  m.state.of<StabilityState>().curve = 2;
  const std::vector<StatedLine> lines = stated_lines(m.frame);
  ASSERT_GT(lines.size(), 4u);
  EXPECT_EQ(lines[0].curve, 2u);
  bool holding = false, failing = false;
  for (const StatedLine& l : lines) {
    if (l.curve == 2) continue;
    EXPECT_FALSE(holding && l.mark == StatedLine::Mark::fails) << "failing ones come before holding ones";
    holding |= l.mark == StatedLine::Mark::holds;
    failing |= l.mark == StatedLine::Mark::fails;
    const bool says_so = l.text.find("DOES NOT HOLD: ") != std::string::npos;
    EXPECT_EQ(says_so, l.mark == StatedLine::Mark::fails) << l.text;
  }
  EXPECT_TRUE(failing) << "the values are made up";
}

TEST(StabilityViews, ZerosHaveATickAndWhatIsNotFiniteStandsInSight) {
  SweepDesk desk;
  const Sweep& s = sweep("view-distance");
  desk.measure(s);
  Model m(desk.input, s);
  const SweepAxes axes = sweep_axes(m.frame);
  EXPECT_EQ(axes.x.logarithmic, s.log_axis);
  EXPECT_TRUE(axes.y.logarithmic);
  ASSERT_TRUE(axes.y.zero_at);
  EXPECT_EQ(ticks_seen(axes.y).front().label, "0");
  EXPECT_TRUE(axes.not_finite);
  m.state.of<StabilityState>().log_y = false;
  EXPECT_FALSE(sweep_axes(m.frame).y.logarithmic);
}

TEST(StabilityViews, ACurveThatCannotBeDrawnSaysWhy) {
  SweepDesk desk;
  desk.runner.emplace(sweep("view-distance"), SweepRun{});  // a device without anything beyond the core path
  desk.input.result = &desk.runner->result();
  Model m(desk.input, sweep("view-distance"));
  bool absent = false;
  for (const StatedLine& l : stated_lines(m.frame)) absent |= l.mark == StatedLine::Mark::not_drawn;
  EXPECT_TRUE(absent);
}

}  // namespace
}  // namespace gbl::ui
