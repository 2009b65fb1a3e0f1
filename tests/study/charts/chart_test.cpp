#include "renderer/study/charts/chart.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/base/random.h"
#include "renderer/study/charts/gnuplot.h"
#include "renderer/truth/measure.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

bool beats(const CostError& a, const CostError& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

void expect_front(const std::vector<CostError>& points) {
  const std::vector<bool> front = pareto_front(points);
  ASSERT_EQ(front.size(), points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    bool beaten = false;
    for (const CostError& other : points) beaten |= beats(other, points[i]);
    EXPECT_EQ(front[i], !beaten) << i << ": " << points[i].cost << ", " << points[i].error;
  }
}

TEST(ParetoFront, HoldsThePointsThatNoneBeats) {
  Pcg32 random(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<CostError> points;
    for (int i = 0; i < 60; ++i) points.push_back({random.unit(), random.unit()});
    expect_front(points);
  }
}

TEST(ParetoFront, TiesAreKeptTogether) {
  Pcg32 random(8);
  for (int round = 0; round < 50; ++round) {
    std::vector<CostError> points;  // on a coarse grid: many are equal in one or both
    for (int i = 0; i < 60; ++i) points.push_back({std::floor(random.in(0, 6)), std::floor(random.in(0, 6))});
    expect_front(points);
  }
  EXPECT_EQ(pareto_front(std::vector<CostError>{{1, 1}, {1, 1}}), (std::vector<bool>{true, true}));
  EXPECT_EQ(pareto_front(std::vector<CostError>{{1, 2}, {1, 1}, {2, 1}}), (std::vector<bool>{false, true, false}));
  EXPECT_TRUE(pareto_front({}).empty());
}

StudyRow row(double cost, const ColumnValue& error, std::vector<Assignment> at = {}) {
  return test::row_of("c", {{"mib", cost}, {"rmse_linear", error}}, std::move(at));
}

StudyRow timed(double median, double p10, double p90, double error) {
  return test::row_of("t", {{"time_ms_total_median", median},
                            {"time_ms_total_p10", p10},
                            {"time_ms_total_p90", p90},
                            {"rmse_linear", error}});
}

// 30 % is still a time; the quickest set-up of all is none, where nobody knows how long it took.
TEST(ChartPoints, ANoisyTimeIsMarkedAndNeverOnTheFront) {
  const std::vector<StudyRow> rows = {timed(10, 9, 12, 0.5), timed(2, 1.9, 2.6, 0.5), timed(20, 19.9, 20.1, 0.4)};
  const Chart chart = chart_points(rows, "time_ms_total_median", "rmse_linear", "lights.method");
  ASSERT_EQ(chart.points.size(), 3u);
  EXPECT_FALSE(chart.points[0].noisy);
  EXPECT_TRUE(chart.points[1].noisy);
  EXPECT_TRUE(chart.points[0].on_front);
  EXPECT_FALSE(chart.points[1].on_front);
  EXPECT_TRUE(chart.points[2].on_front);
  const std::string script = chart_script(chart, {"t", "s"}, ChartFile::svg);
  EXPECT_NE(script.find("'noisy time'"), std::string::npos);
  const Chart counts = chart_points({row(1, 0.5)}, "mib", "rmse_linear", "lights.method");
  EXPECT_FALSE(counts.points[0].noisy) << "what is no time cannot be";
  EXPECT_EQ(chart_script(counts, {"t", "s"}, ChartFile::svg).find("'noisy time'"), std::string::npos);
}

TEST(ChartPoints, SaysWhereTwoVersionsMeasured) {
  std::vector<StudyRow> rows = {row(1, 0.5), row(2, 0.4), row(3, 0.3)};
  rows[0].made_by = rows[1].made_by = "0.5.0 a";
  EXPECT_EQ(mixed_programs(chart_points(rows, "mib", "rmse_linear", "lights.method")), "");
  rows[2].made_by = "0.6.0 b";
  EXPECT_EQ(mixed_programs(chart_points(rows, "mib", "rmse_linear", "lights.method")),
            "measured by 2 versions of the program: 0.5.0 a; 0.6.0 b");
}

TEST(ChartPoints, LeavesOutWhatIsNotMeasuredAndCountsIt) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<StudyRow> rows = {row(1, 0.5), row(2, {}), row(3, kInfinity), test::failed_row_of("f", "why"),
                                      row(4, 0.7)};
  const Chart chart = chart_points(rows, "mib", "rmse_linear", "lights.method");
  ASSERT_EQ(chart.points.size(), 2u);
  EXPECT_EQ(chart.without_value, 2u);
  EXPECT_EQ(chart.failed, 1u);
  EXPECT_EQ(chart.points[1].row, 4u);
  EXPECT_TRUE(chart.points[0].on_front);
  EXPECT_FALSE(chart.points[1].on_front);
}

TEST(ChartPoints, NameFamilyAndPreset) {
  std::vector<StudyRow> rows = {row(1, 1, {{"lights.method", "auto"}}), row(2, 1, {{"preset", "nclgl"}})};
  rows[0].settings.lights.method = LightMethod::quads;
  rows[1].settings.lights.method = LightMethod::volumes;
  const Chart chart = chart_points(rows, "mib", "rmse_linear", "lights.method");
  EXPECT_EQ(chart.points[0].family, "auto") << "as asked for";
  EXPECT_EQ(chart.points[1].family, "volumes") << "as drawn";
  EXPECT_EQ(chart.points[0].label, "c");
  EXPECT_FALSE(chart.points[0].preset);
  EXPECT_EQ(chart.points[1].label, "nclgl");
  EXPECT_TRUE(chart.points[1].preset);
  EXPECT_EQ(chart.families, (std::vector<std::string>{"auto", "volumes"}));
}

TEST(ChartPoints, AQualityIsBetterWhenItIsMore) {
  std::vector<StudyRow> rows;
  for (const double psnr : {40, 30, 50})
    rows.push_back(test::row_of("c", {{"mib", double(rows.size() + 1)}, {"psnr_display", psnr}}));
  const Chart chart = chart_points(rows, "mib", "psnr_display", "layout");
  EXPECT_TRUE(chart.points[0].on_front);
  EXPECT_FALSE(chart.points[1].on_front);
  EXPECT_TRUE(chart.points[2].on_front);
  EXPECT_FALSE(axis_for(chart.y, {30, 50}).logarithmic);
}

TEST(ChartAxis, IsTitledWithItsUnit) {
  EXPECT_EQ(axis_title(cost_column("mib")), "all targets of a frame [MiB]");
  EXPECT_EQ(axis_title(cost_column("draw_calls")), "draw calls");
}

TEST(ChartAxis, DrawsZeroADecadeBelowTheSmallest) {
  const ChartAxis axis = axis_for(chart_error_column("rmse_linear"), {0, 0.02, 3});
  ASSERT_TRUE(axis.zero_at);
  EXPECT_DOUBLE_EQ(*axis.zero_at, 0.002);
  EXPECT_EQ(axis.place(0), *axis.zero_at);
  EXPECT_EQ(axis.place(0.02), 0.02);
  EXPECT_LT(axis.low, *axis.zero_at);
  EXPECT_GT(axis.high, 3);
  EXPECT_FALSE(axis_for(chart_error_column("rmse_linear"), {0.02, 3}).zero_at);
}

std::vector<std::string> labels(const ChartAxis& axis) {
  std::vector<std::string> list;
  for (const ChartTick& t : ticks_of(axis)) list.push_back(t.label);
  return list;
}

TEST(ChartTicks, AreRoundNumbersWithinTheAxis) {
  const StudyColumn &cost = cost_column("mib"), &quality = chart_error_column("psnr_display");
  EXPECT_EQ(labels(axis_for(cost, {4, 44})), (std::vector<std::string>{"5", "10", "20", "50"}));
  EXPECT_EQ(labels(axis_for(cost, {0, 3})), (std::vector<std::string>{"0", "3", "3.2", "3.4", "3.6", "3.8", "4"}));
  EXPECT_EQ(labels(axis_for(cost, {0.001, 20})), (std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10"}));
  EXPECT_EQ(labels(axis_for(cost, {0, 0.02, 3})), (std::vector<std::string>{"0", "0.1", "1"}));
  EXPECT_EQ(labels(axis_for(quality, {31, 44})), (std::vector<std::string>{"32", "34", "36", "38", "40", "42", "44"}));
  Pcg32 random(4);
  for (int i = 0; i < 500; ++i) {
    const double a = std::exp(random.in(-60, 60)), b = a * std::exp(random.in(0, i % 2 ? 40 : 2));
    for (const StudyColumn& column : {cost, quality}) {
      const ChartAxis axis = axis_for(column, {a, b});
      const std::vector<ChartTick> ticks = ticks_of(axis);
      EXPECT_GE(ticks.size(), 2u) << a << " " << b;
      EXPECT_LE(ticks.size(), 12u) << a << " " << b;
      for (const ChartTick& t : ticks) EXPECT_TRUE(t.at >= axis.low && t.at <= axis.high) << a << " " << b;
    }
  }
}

TEST(ChartAxis, IsUsableWithoutASpread) {
  for (const std::vector<double>& values : {std::vector<double>{}, {0}, {0, 0}, {5}, {1e-300}}) {
    const ChartAxis axis = axis_for(cost_column("mib"), values);
    EXPECT_GT(axis.low, 0);
    EXPECT_LT(axis.low, axis.high);
    EXPECT_TRUE(std::isfinite(axis.high));
  }
  const ChartAxis linear = axis_for(chart_error_column("psnr_display"), {40});
  EXPECT_LT(linear.low, 40);
  EXPECT_GT(linear.high, 40);
}

}  // namespace
}  // namespace gbl
