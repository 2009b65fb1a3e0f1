#include "renderer/study/rows/study_row.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

#include "renderer/base/json.h"
#include "renderer/study/row_json.h"
#include "renderer/study/study_files.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

TEST(SpreadOf, TakesNearestRanks) {
  std::vector<double> ms;
  for (int i = 20; i >= 1; --i) ms.push_back(i);
  const TimeSpread t = spread_of(ms);
  EXPECT_EQ(t.median, 10);
  EXPECT_EQ(t.p10, 2);
  EXPECT_EQ(t.p90, 18);
  EXPECT_EQ(spread_of({7}).median, 7);
  EXPECT_EQ(spread_of({7}).p90, 7);
}

TEST(MeasuredEnough, StopsAtFramesOrSecondsButNeverTooSoon) {
  EXPECT_TRUE(measured_enough(20, 0.1, 0.01));
  EXPECT_FALSE(measured_enough(19, 19, 1));
  EXPECT_FALSE(measured_enough(2, 30, 15));
  EXPECT_TRUE(measured_enough(3, 30, 10));
  EXPECT_TRUE(measured_enough(1, 25, 25));  // a frame longer than all the time there is
  EXPECT_FALSE(measured_enough(0, 0, 0));
}

// Everything that can be measured, and each number another.
struct Sample {
  Sample() {
    report.size = {640, 360};
    report.time_source = "software-rasteriser";
    report.pairs = {.tested = 300, .shaded = 200, .lit = 100};
    report.draw_calls = 7, report.gbuffer_bytes_per_pixel = 12, report.accumulation_bytes_per_pixel = 16;
    report.mib = 1.5;
    double k = 0.125;
    for (const ErrorColumn& c : error_columns()) errors.*c.value = k += 1;
    timing.pass_ms = {{"lighting", {3, 1, 2}}, {"total", {6, 4, 5}}};
    timing.frames = 3;
  }
  Measurement measurement() const { return {report, errors, timing, machine}; }
  FrameReport report;
  Errors errors;
  Timing timing;
  Machine machine{"a driver", "a device"};
};

StudyRow sample_row() {
  StudyRow row{.study = "t", .name = "lights=3", .key = "k", .at = {{"lights", 3}, {"camera.fov", 60.0}}};
  row.cells = cells_of(Sample().measurement());
  row.settings.lights.count = 3;
  row.settings.mistakes = {Mistake::tbn_precedence};
  return row;
}

size_t times_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<size_t>(std::count(names.begin(), names.end(), name));
}

TEST(StudyColumns, EachStandsOnceInEveryFileAndOnOneAxisAtMost) {
  const StudyRow row = sample_row();
  const Json json = to_json(row);
  std::vector<std::string> members, header, axes;
  for (const auto& [member, value] : json.items()) members.push_back(member);
  std::stringstream csv(study_csv({row}, {}));
  std::string line;
  std::getline(csv, line, '\r');
  std::stringstream names(line);
  for (std::string name; std::getline(names, name, ',');) header.push_back(name);
  for (const auto& columns : {cost_columns(), chart_error_columns()})
    for (const StudyColumn& c : columns) axes.push_back(c.id);
  for (const StudyColumn& c : study_columns()) {
    const bool in_files = c.numerator.empty();  // a ratio is worked out from two that are
    EXPECT_EQ(times_in(members, c.id), in_files) << c.id;
    EXPECT_EQ(times_in(header, c.id), in_files) << c.id;
    EXPECT_EQ(times_in(axes, c.id), c.axis != Axis::none) << c.id;
    const bool counts = c.id == "compared_pixels" || c.id == "tie_pixels" || c.id == "blended_pixels";
    EXPECT_EQ(c.label.empty(), c.axis == Axis::none && !counts) << c.id;
    EXPECT_TRUE(c.axis == Axis::none || column_value(row, c)) << c.id << " is not taken from a measurement";
  }
  for (const StudyColumn& c : study_columns())
    for (const std::string& other : {c.share_of, c.p10, c.p90, c.numerator, c.denominator})
      EXPECT_TRUE(other.empty() || row.number(other)) << c.id << " speaks of " << other;
}

TEST(StudyColumns, CostsAreOfferedInTheOrderOfTheirPlaces) {
  int place = 0;
  for (const StudyColumn& c : cost_columns()) EXPECT_EQ(c.place, ++place) << c.id;
}

TEST(StudyColumns, AreKnownByIdAndRatiosAreDerived) {
  const StudyRow full = test::row_of("a", {{"pairs_shaded", 300}, {"pairs_lit", 100}, {"signed_mean_linear", -0.25}});
  EXPECT_EQ(column_value(full, cost_column("shaded_per_lit")), 3.0);
  EXPECT_EQ(column_value(full, chart_error_column("signed_mean_linear")), 0.25);
  for (const ColumnValue& lit : {ColumnValue(0), ColumnValue()})
    EXPECT_FALSE(
        column_value(test::row_of("a", {{"pairs_shaded", 300}, {"pairs_lit", lit}}), cost_column("shaded_per_lit")));
  EXPECT_EQ(chart_error_columns().size() + 3, error_columns().size()) << "all but the three that count pixels";
  const std::string line = error_line(ExitCode::bad_input, [] { cost_column("draw_cals"); });
  EXPECT_TRUE(contains(line, "did you mean 'draw_calls'")) << line;
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [] { chart_error_column("rmse"); }), "rmse_linear"));
}

TEST(StudyRow, ComesBackFromItsLineInTheJournal) {
  const StudyRow row = sample_row();
  const std::string line = journal_line(row);
  const auto again = parse_journal_line(line, "rows.jsonl:1");
  ASSERT_TRUE(again);
  EXPECT_TRUE(*again == row) << line;
  EXPECT_EQ(journal_line(*again), line) << "to the byte";
  const StudyRow failed = test::failed_row_of("b", "no memory");
  EXPECT_TRUE(*parse_journal_line(journal_line(failed), "") == failed);
}

TEST(StudyRow, NumbersAreWrittenAsTheyAreCountedOrMeasured) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const StudyRow row = test::row_of("a", {{"mib", 3.0}, {"frames", 3}, {"psnr_display", kInfinity}, {"flip_mean", {}}});
  const std::string line = journal_line(row);
  EXPECT_TRUE(contains(line, R"("mib":3.0,"frames":3,"psnr_display":"inf","flip_mean":null)")) << line;
  EXPECT_EQ(parse_journal_line(line, "")->number("psnr_display"), kInfinity);
  EXPECT_FALSE(parse_journal_line(line, "")->number("flip_mean")) << "unknown is empty, never zero";
}

TEST(StudyRow, OfAnotherProgramIsRefusedWithItsPlace) {
  std::string line = journal_line(sample_row());
  line.replace(line.find("\"ambient\""), 9, "\"ambiant\"");
  const std::string message = error_line(ExitCode::bad_input, [&] { parse_journal_line(line, "rows.jsonl:7"); });
  EXPECT_TRUE(contains(message, "rows.jsonl:7: ambiant: unknown option")) << message;
}

TEST(StudyRow, HasEveryErrorColumnAndNoneIsInvented) {
  const FrameReport report;
  const std::vector<Cell> cells = cells_of({report, {}, {}, {}});
  for (const ErrorColumn& c : error_columns()) {
    const auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& x) { return x.column == c.id; });
    ASSERT_TRUE(cell != cells.end()) << c.id;
    EXPECT_TRUE(std::holds_alternative<std::monostate>(cell->value)) << c.id;
    EXPECT_GT(std::string(c.help).size(), 3u);
  }
}

TEST(StudyRow, TimesAreTheSpreadOfTheFrames) {
  const StudyRow row = sample_row();
  EXPECT_EQ(row.number("time_ms_lighting_median"), 2);
  EXPECT_EQ(row.number("time_ms_total_p90"), 6);
  EXPECT_EQ(row.number("frames"), 3);
  EXPECT_EQ(row.text("size"), "640x360");
  StudyRow unknown = row;
  unknown.cells = cells_of({FrameReport{}, {}, {}, {}});
  EXPECT_FALSE(unknown.number("pairs_lit")) << "unknown is empty, never zero";
}

}  // namespace
}  // namespace gbl
