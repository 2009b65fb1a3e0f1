// Studies beside the window's picture: in slices, with the rows that a Bench at once would give, and without a trace in
// the picture.
#include "app/background_study.h"

#include <filesystem>
#include <fstream>

#include "tests/app/viewer_fixture.h"

namespace gbl::test {
namespace {

constexpr const char* kFew = R"({"version": 1, "name": "few", "label": "few", "base": {"scene": "builtin:hall"},
  "permute": {"normal.encoding": ["oct8", "xyz8"], "lights.method": ["clustered", "fullscreen"], "lights": [4, 16]},
  "x": "time_ms_total_median", "y": "rmse_linear", "family": "lights.method"})";
constexpr size_t kFewCases = 8;

class BackgroundStudies : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    folder_ = std::filesystem::temp_directory_path() / fmt::format("gbl-background-{}", getpid());
    std::filesystem::create_directories(folder_);
    few_ = (folder_ / "few.json").string();
    std::ofstream(few_) << kFew;
  }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
    ViewerTest::TearDown();
  }

  const ui::ChartInput& chart() const { return *viewer_->input(0).chart; }

  // A window frame; true while there is more to come.
  bool frame(const Settings& s, ui::ChartRequest asked, bool quiet = true) {
    ui::Requests r = showing({View::final});
    r.chart = std::move(asked);
    viewer_->update(s, r, false);
    viewer_->measure(s, r, quiet);
    return viewer_->busy();
  }
  void run_to_end(const Settings& s, const ui::ChartRequest& asked) {
    int frames = 0;
    while (frame(s, asked) && frames < 5000) ++frames;
    EXPECT_FALSE(viewer_->busy());
  }
  void run_until_done(size_t rows, const Settings& s, const ui::ChartRequest& asked) {
    for (int frames = 0; chart().done < rows && frames < 2000; ++frames) frame(s, asked);
    ASSERT_EQ(chart().done, rows);
  }
  Settings settled() {
    Settings s = yard_settings();
    frame(s, {});
    settle(s, showing({View::final}));
    return s;
  }

  std::filesystem::path folder_;
  std::string few_;
};

MeasuredColumns measured_at_once(Lab& lab, const Settings& s) {
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
  bench.start(s, lab.gpu_scene(), {.times = false});
  bench.step(true);
  return bench.row();
}

void expect_same_columns(const StudyRow& row, const MeasuredColumns& expected) {
  StudyRow at_once;
  at_once.cells = expected.cells;
  for (const StudyColumn& c : study_columns()) {
    if (c.id == "frames" || c.unit == "ms") continue;
    EXPECT_EQ(row.number(c.id), at_once.number(c.id)) << c.id << " of " << row.name;
  }
}

TEST_F(BackgroundStudies, RowsAreThoseOfABenchAtOnceAndThePictureStays) {
  const Settings s = settled();
  const Image before = lab_->image_of(View::final);
  frame(s, {.study = few_, .run = true});
  EXPECT_TRUE(viewer_->busy());
  run_to_end(s, {.study = few_});
  ASSERT_EQ(chart().rows.size(), kFewCases);
  EXPECT_EQ(chart().done, kFewCases);
  EXPECT_EQ(chart().running, "");
  EXPECT_TRUE(lab_->image_of(View::final) == before);
  EXPECT_EQ(lab_->drawn(), s);
  lab_->draw(s);
  lab_->draw_view(View::final, {.overlays = true});
  EXPECT_TRUE(lab_->image_of(View::final) == before) << "drawn anew it is the same, too";
  for (size_t i = 0; i < kFewCases; ++i) {
    const StudyRow& row = chart().rows[i];
    ASSERT_FALSE(row.failed) << *row.failed;
    EXPECT_TRUE(row.number("time_ms_total_median"));
    EXPECT_EQ(row.text("size"), "320x180");
    expect_same_columns(row, measured_at_once(*lab_, chart().settings[i]));
    EXPECT_EQ(chart().settings[i].camera, s.camera);
    EXPECT_EQ(chart().settings[i].scene, "yard");
  }
}

TEST_F(BackgroundStudies, AFrameIsOnePieceOfWorkAndOnlyWhileItIsQuiet) {
  const Settings s = settled();
  frame(s, {.study = few_, .run = true}, false);
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(frame(s, {.study = few_}, false)) << "it waits, and the loop goes on";
  EXPECT_EQ(chart().done, 0u);
  int frames = 0;
  while (chart().done == 0 && frames < 500) frame(s, {.study = few_}), ++frames;
  EXPECT_GT(frames, 5) << "a row is many pieces";
  EXPECT_EQ(chart().done, 1u);
  EXPECT_EQ(chart().total, kFewCases);
  EXPECT_TRUE(chart().seconds_left);
}

TEST_F(BackgroundStudies, ItStopsAndGoesOnWhereItWas) {
  const Settings s = settled();
  frame(s, {.study = few_, .run = true});
  run_until_done(3, s, {.study = few_});
  frame(s, {.study = few_, .stop = true});
  EXPECT_FALSE(viewer_->busy());
  EXPECT_EQ(chart().rows.size(), 3u);
  const StudyRow first = chart().rows[0];
  frame(s, {.study = few_, .run = true});
  run_to_end(s, {.study = few_});
  EXPECT_EQ(chart().rows.size(), kFewCases);
  EXPECT_TRUE(chart().rows[0] == first) << "not measured again";
}

TEST_F(BackgroundStudies, AChangeOfTruthStopsItAndKeepsItsRowsOut) {
  const Settings s = settled();
  frame(s, {.open = true, .study = few_, .run = true});
  run_until_done(2, s, {.open = true, .study = few_});
  Settings other = s;
  other.lights.seed += 1;
  frame(other, {.open = true, .study = few_});
  EXPECT_EQ(chart().running, "");
  EXPECT_NE(chart().note.find("lights.seed"), std::string::npos) << chart().note;
  run_to_end(other, {.open = true, .study = few_});
  ASSERT_EQ(chart().rows.size(), 1u) << "the settings at hand alone";
  EXPECT_EQ(chart().current, 0u);
  run_to_end(s, {.open = true, .study = few_});
  EXPECT_GE(chart().rows.size(), 2u) << "its own truth brings them back";
}

TEST_F(BackgroundStudies, ClosingTheChartLetsItGoOnAndAChangeStopsItThere) {
  Settings s = settled();
  frame(s, {.open = true, .study = few_, .run = true});
  run_until_done(2, s, {.study = few_});
  EXPECT_EQ(chart().running, few_);
  s.exposure *= 2;
  frame(s, {.study = few_});
  EXPECT_EQ(chart().running, "") << "the status bar must not say that it runs";
  settle(s, showing({View::final}));
}

TEST_F(BackgroundStudies, TruthThatTheStudyVariesIsNoChange) {
  Settings s = settled();
  frame(s, {.study = few_, .run = true});
  run_to_end(s, {.study = few_});
  ASSERT_EQ(chart().rows.size(), kFewCases);
  Settings row = chart().settings[5];  // as a click on its point applies it
  row.size = s.size, row.view = s.view;
  EXPECT_NE(row.lights.count, s.lights.count);
  run_to_end(row, {.open = true, .study = few_});
  EXPECT_EQ(chart().rows.size(), kFewCases);
  EXPECT_EQ(chart().current, 5u) << "it is that very point: nothing is measured anew";
}

TEST_F(BackgroundStudies, TheSettingsAtHandAreMeasuredWhenTheyChangeAndOnlyWithTheChartOpen) {
  Settings s = settled();
  EXPECT_FALSE(frame(s, {}));
  EXPECT_TRUE(chart().rows.empty());
  run_to_end(s, {.open = true});
  ASSERT_EQ(chart().rows.size(), 1u);
  EXPECT_EQ(chart().current, 0u);
  expect_same_columns(chart().rows[0], measured_at_once(*lab_, chart().settings[0]));
  s.normal.encoding = NormalEncoding::oct8;
  frame(s, {.open = true}, false);
  EXPECT_FALSE(chart().current);
  EXPECT_TRUE(chart().measuring);
  run_to_end(s, {.open = true});
  EXPECT_EQ(chart().rows.size(), 2u) << "what was tried before stays beside it";
  EXPECT_EQ(chart().current, 1u);
  s.normal.encoding = NormalEncoding::oct16;
  frame(s, {.open = true});
  EXPECT_EQ(chart().current, 0u) << "known: nothing to wait for";
  s.normal.encoding = NormalEncoding::xyz8;
  frame(s, {.open = true});
  frame(s, {});  // closed
  settle(s, showing({View::final}));
  EXPECT_FALSE(frame(s, {})) << "a window at rest does no work";
}

TEST_F(BackgroundStudies, WhatCannotBeMeasuredIsARowWithItsReason) {
  Settings s = settled();
  lab_->cost().learn(LightMethod::volumes, 1e6, 50000);  // the machine is believed to be very slow
  lab_->cost().learn(LightMethod::volumes, 1e6, 50000);
  s.lights.method = LightMethod::fullscreen;
  s.size = {4, 4};
  run_to_end(s, {.open = true});
  ASSERT_EQ(chart().rows.size(), 1u);
  ASSERT_TRUE(chart().rows[0].failed);
  EXPECT_NE(chart().rows[0].failed->find("predicted"), std::string::npos);
  EXPECT_EQ(chart().current, 0u) << "it is not tried again and again";
}

TEST_F(BackgroundStudies, AStudyThatIsNoneIsANoteAndANewSceneForgets) {
  const Settings s = settled();
  frame(s, {.open = true, .study = "no-such-study", .run = true});
  EXPECT_NE(chart().note.find("no-such-study"), std::string::npos) << chart().note;
  run_to_end(s, {.open = true, .study = "no-such-study"});
  EXPECT_EQ(chart().rows.size(), 1u);
  EXPECT_GE(chart().studies.size(), 5u);
  lab_->show("yard", std::make_shared<const Scene>(make_yard(1)));
  frame(s, {.open = true, .study = few_}, false);
  EXPECT_TRUE(chart().rows.empty());
}

}  // namespace
}  // namespace gbl::test
