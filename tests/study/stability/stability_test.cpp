// Statements checked on made-up curves, and the sweeps as data: nothing is drawn here.
#include "renderer/study/stability/stability.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/light/lights.h"
#include "renderer/study/stability/stability_chart.h"
#include "renderer/study/stability/stability_files.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Points = std::vector<CurvePoint>;

// y = scale x^power at 1, 10, 100, 1000
Points line(double scale, double power) {
  Points out;
  for (const double x : {1.0, 10.0, 100.0, 1000.0}) out.push_back({x, scale * std::pow(x, power)});
  return out;
}

void expect_broken(const Expected& e, const Points& points, const std::string& where) {
  const Verdict v = check(e, points);
  EXPECT_FALSE(v.holds) << where;
  EXPECT_NE(v.where.find(where), std::string::npos) << v.where;
}

TEST(StabilityStatement, FlatIsNeverAboveItsBound) {
  EXPECT_TRUE(check(Flat{0.5}, Points{{1, 0.5}, {2, 0}}).holds);
  expect_broken(Flat{0.5}, {{1, 0.4}, {2, 0.6}, {3, 0.7}}, "at 2 it is 0.6");  // the first such place
}

TEST(StabilityStatement, WhatIsNotANumberIsAboveEveryBound) {
  expect_broken(Flat{1e300}, {{1, 0}, {2, kNan}}, "at 2");
  expect_broken(Flat{1e300}, {{1, kNoEnd}}, "at 1");
  EXPECT_TRUE(check(FailsOften{.bound = 1e300, .share = 1}, Points{{1, kNan}, {2, kNoEnd}}).holds);
}

TEST(StabilityStatement, NothingMeasuredProvesNothing) {
  const Points absent = {{1, std::nullopt}};
  for (const Expected& e : {Expected(Flat{1}), Expected(Diverges{1, 1, 0, 0}), Expected(FailsIn{.from = 1, .to = 1}),
                            Expected(Grows{}), Expected(FailsOften{.share = 1}), Expected(FailsOften{}),
                            Expected(Wobbles{}), Expected(Least{.from = -kNoEnd, .to = kNoEnd})}) {
    EXPECT_FALSE(check(e, absent).holds);
    EXPECT_FALSE(check(e, Points{}).holds);
  }
  expect_broken(Diverges{.up_to = 1, .from = 5, .holds = 1, .fails = 1}, {{1, 0}, {2, 9}}, "nothing was measured");
}

TEST(StabilityStatement, DivergesHoldsUpToAPointAndFailsFromAnother) {
  const Diverges e{.up_to = 2, .from = 4, .holds = 0.1, .fails = 0.9};
  EXPECT_TRUE(check(e, Points{{1, 0}, {2, 0.1}, {3, 0.5}, {4, 1}, {5, 1}}).holds);
  expect_broken(e, {{1, 0}, {2, 0.2}, {4, 1}}, "at 2");
  expect_broken(e, {{1, 0}, {4, 1}, {5, 0.9}}, "at 5");
}

TEST(StabilityStatement, FailsInAnIntervalAndComesBack) {
  const FailsIn e{.before = 1, .from = 2, .to = 3, .beyond = 4, .holds = 0, .fails = 0.9};
  EXPECT_TRUE(check(e, Points{{1, 0}, {2, 1}, {3, 1}, {3.5, 0.4}, {4, 0}}).holds);
  expect_broken(e, {{1, 0}, {2, 1}, {3, 0.8}, {4, 0}}, "at 3");
  expect_broken(e, {{1, 0.1}, {2, 1}, {4, 0}}, "at 1");
  expect_broken(e, {{1, 0}, {2, 1}, {4, 0}, {9, 0.1}}, "at 9");
  const FailsIn for_ever{.before = 1, .from = 2, .to = kNoEnd, .holds = 0, .fails = 0.9};
  EXPECT_TRUE(check(for_ever, Points{{1, 0}, {2, 1}, {3, 1}}).holds);
}

TEST(StabilityStatement, GrowsAsAPowerFromALevelWithoutLeaps) {
  const Grows square{.slope = 2, .tolerance = 0.1, .at = 10, .low = 250, .high = 350};
  EXPECT_TRUE(check(square, line(3, 2)).holds);
  expect_broken(square, line(3, 1.8), "the power is 1.8");
  expect_broken(square, line(4, 2), "the line is at 400");
  Points leap = line(3, 2);
  leap[1].value = 3 * *leap[1].value;
  expect_broken(Grows{.slope = 2, .tolerance = 1, .at = 10, .low = 1, .high = 1e4}, leap, "times the line");
  Points zero = line(3, 2);
  zero[0].value = 0;
  expect_broken(square, zero, "a number above 0");
  expect_broken(square, {{1, 3}, {10, 300}}, "fewer than three points");
}

TEST(StabilityStatement, WobblesFromItsSmallestToItsLargestValue) {
  const Points wave = {{1, -2}, {2, 1}, {3, -3}, {4, 0}};
  EXPECT_TRUE(check(Wobbles{.least = 4, .most = 4}, wave).holds);
  expect_broken(Wobbles{.least = 4.1}, wave, "from -3 at 3 to 1 at 2");
  expect_broken(Wobbles{.most = 3.9}, wave, "wobbles by 4");
  expect_broken(Wobbles{}, {{1, 0}, {2, kNan}}, "at 2");
}

TEST(StabilityStatement, LeastLiesBetweenTwoHigherEnds) {
  const Points valley = {{1, 9}, {2, 3}, {4, 2}, {8, 5}};
  EXPECT_TRUE(check(Least{.from = 3, .to = 5, .most = 2, .ends = 4}, valley).holds);
  expect_broken(Least{.from = 5, .to = 9, .most = 2, .ends = 4}, valley, "is 2, at 4");
  expect_broken(Least{.from = 3, .to = 5, .most = 1, .ends = 4}, valley, "is 2, at 4");
  expect_broken(Least{.from = 3, .to = 5, .most = 2, .ends = 6}, valley, "at 8 it is 5");
  expect_broken(Least{.from = 3, .to = 5, .most = 2}, {{1, 9}, {4, kNan}, {8, 9}}, "at 4");
}

TEST(StabilityStatement, FailsOftenCountsConfigurationsOfItsFamilyOnly) {
  Points p;
  for (int k = 0; k < 100; ++k) p.push_back({double(k), k % 2 ? 1.0 : 0.0});
  p.push_back({1000, 0});
  EXPECT_TRUE(check(FailsOften{.from = 0, .to = 999, .share = 0.4}, p).holds);
  expect_broken(FailsOften{.from = 0, .to = 999, .share = 0.3}, p, "50 % (50 of 100)");  // chance allows 14.5 %
  expect_broken(FailsOften{.from = 0, .to = 999}, p, "50 %");                            // none is none
  EXPECT_TRUE(check(FailsOften{.from = 1000, .to = 1999}, p).holds);
  expect_broken(FailsOften{.from = 2000, .to = 2999}, p, "nothing was measured");
}

TEST(StabilityStatement, TextNamesTheBounds) {
  const AxisWords words{"distance", "units", "lost_share", ""};
  EXPECT_EQ(text_of(Flat{0.25}, words), "is flat: lost_share is never above 0.25");
  EXPECT_EQ(text_of(FailsIn{.before = 1, .from = 2, .to = 3, .beyond = 4, .holds = 0, .fails = 0.9}, words),
            "fails from 2 to 3 units: lost_share is above 0.9 there, at most 0 up to 1 units and from 4 units on");
  EXPECT_EQ(text_of(FailsOften{.from = 1000, .to = 1999}, {"configuration", "", "worst", "", true}),
            "never fails: worst is above 0 in none of family B");
}

// ---- the sweeps -----------------------------------------------------------------------------------------------------

DeviceLimits everything() {
  DeviceLimits limits;
  for (const FeatureRow& r : kFeatures) limits.features.add(r.feature);
  return limits;
}

constexpr DeviceRounding kNearest{};
constexpr DeviceRounding kTruncates{StoreRounding::toward_zero, StoreRounding::toward_zero, StoreRounding::toward_zero};

TEST(Stability, IdsAreUniqueAndEveryRowIsWhole) {
  std::set<std::string> ids;
  for (const Sweep& s : sweeps()) {
    EXPECT_TRUE(ids.insert(s.id).second) << s.id;
    EXPECT_EQ(&sweep(s.id), &s);
    for (const char* text : {s.label, s.parameter, s.help, s.metric}) EXPECT_STRNE(text, "") << s.id;
    EXPECT_NO_THROW(sweep_metric(s.metric));
  }
  EXPECT_EQ(ids.size(), sweeps().size());
}

TEST(Stability, AnUnknownSweepIsAnErrorThatListsTheKnownOnes) {
  try {
    sweep("light-distanze");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_input);
    EXPECT_NE(std::string(e.what()).find("did you mean 'light-distance'? known: "), std::string::npos) << e.what();
  }
}

TEST(Stability, ValuesAreSortedFiniteAndFewEnoughToWaitFor) {
  for (const Sweep& s : sweeps()) {
    const std::vector<double> values = s.values();
    ASSERT_GE(values.size(), 5u) << s.id;
    EXPECT_LE(values.size(), 150u) << s.id;
    for (size_t i = 0; i < values.size(); ++i) {
      EXPECT_TRUE(std::isfinite(values[i])) << s.id;
      EXPECT_TRUE(i == 0 || values[i - 1] < values[i]) << s.id << " " << values[i];
      EXPECT_TRUE(!s.log_axis || values[i] > 0) << s.id << " " << values[i];
    }
  }
}

TEST(Stability, EverySetupIsValidSmallAndHasALightInAFiniteScene) {
  for (const Sweep& s : sweeps())
    for (const double x : s.values())
      for (const Curve& c : s.curves(kTruncates)) {
        const SweepSetup setup = setup_at(s, c, x);
        const std::vector<Problem> problems = validate(setup.settings, everything());
        ASSERT_TRUE(problems.empty()) << s.id << " " << c.id << " " << x << ": " << problems[0].sentence;
        ASSERT_LE(setup.settings.size.x * setup.settings.size.y, 160 * 90);
        ASSERT_EQ(setup.settings.scene, setup.scene->name);  // truths are kept by it
        ASSERT_FALSE(lights_of(setup.settings, *setup.scene).empty()) << s.id << " " << x;
      }
}

TEST(Stability, EveryCurveHasAnIdOfItsOwnAndAStatement) {
  for (const DeviceRounding& rounding : {kNearest, kTruncates})
    for (const Sweep& s : sweeps()) {
      std::set<std::string> ids;
      for (const Curve& c : s.curves(rounding)) {
        EXPECT_TRUE(ids.insert(c.id).second) << c.id;
        EXPECT_EQ(c.id.find_first_of(",\"\n"), std::string::npos) << c.id;  // a cell of a table
        ASSERT_FALSE(c.expected.empty()) << c.id;
        for (const Expected& e : c.expected) EXPECT_NE(text_of(e, words_of(s)).find(s.metric), std::string::npos);
      }
    }
}

// A statement that always holds says nothing: each is broken by a curve of zeros or by a curve without end.
TEST(Stability, NoStatementHoldsWhateverIsMeasured) {
  for (const Sweep& s : sweeps())
    for (const Curve& c : s.curves(kNearest))
      for (const Expected& e : c.expected) {
        Points zeros, endless;
        for (const double x : s.values()) zeros.push_back({x, 0}), endless.push_back({x, kNoEnd});
        EXPECT_FALSE(check(e, zeros).holds && check(e, endless).holds) << s.id << " " << c.id;
      }
}

TEST(Stability, ConfigurationsAreTheSameEveryTime) {
  const Sweep& s = sweep("cull-families");
  for (const double x : s.values())
    EXPECT_EQ(s.at(x).scene->lights[0].position, s.at(x).scene->lights[0].position) << x;
  EXPECT_NE(s.at(0).scene->lights[0].position, s.at(1).scene->lights[0].position);
}

// ---- the run --------------------------------------------------------------------------------------------------------

Measured nothing_lost(const SweepSetup&) {
  auto truth = std::make_shared<Truth>();
  truth->size = {1, 1};
  truth->present = {1};
  truth->lit = truth->diffuse = truth->specular = truth->albedo = truth->position = {glm::dvec3(1)};
  Measured m{.truth = truth};
  m.errors.lost_pixels = 0, m.errors.doubled_pixels = 0;
  return m;
}

SweepResult run(const char* id, const MeasureFn& measure, const DeviceLimits& limits = everything()) {
  const std::atomic<bool> never{false};
  return run_sweep(sweep(id), {.limits = limits}, measure, nullptr, never);
}

TEST(Stability, ARunMeasuresEveryPointOfEveryCurveAndJudgesIt) {
  const SweepResult r = run("far-plane", nothing_lost);
  ASSERT_EQ(r.curves.size(), 5u);
  for (const CurveResult& c : r.curves) EXPECT_EQ(c.rows.size(), sweep("far-plane").values().size());
  EXPECT_FALSE(r.curves[0].judged[0].verdict.holds);  // it is said to lose the light
  EXPECT_TRUE(r.curves[1].judged[0].verdict.holds);
  EXPECT_FALSE(r.holds());
}

TEST(Stability, WhatADeviceCannotDrawIsSaidAndNotJudged) {
  DeviceLimits limits = everything();
  limits.features.remove(Feature::clip_control);
  const SweepResult r = run("near-plane", nothing_lost, limits);
  EXPECT_NE(r.curves[3].not_drawn.find("clip-control"), std::string::npos) << r.curves[3].not_drawn;
  EXPECT_TRUE(r.curves[3].rows.empty());
  EXPECT_TRUE(r.curves[3].judged.empty());
}

TEST(Stability, NonFiniteAndAbsentValuesStayWhatTheyAre) {
  const auto measure = [](const SweepSetup& s) {
    Measured m = nothing_lost(s);
    if (s.settings.camera.near > 1) m.errors.position_max = s.settings.camera.near > 3 ? kNan : kNoEnd;
    return m;
  };
  const std::vector<SweepResult> results = {run("near-plane", measure)};
  const CurveResult& c = results[0].curves[0];
  EXPECT_FALSE(c.rows[0].value.has_value());
  EXPECT_TRUE(std::isnan(*c.rows.back().value));
  const std::string csv = stability_csv(results);
  EXPECT_NE(csv.find(",10,position_max,nan,"), std::string::npos) << csv.substr(0, 2000);
  EXPECT_NE(csv.find(",3,position_max,inf,"), std::string::npos);
  EXPECT_NE(csv.find(",0.0001,position_max,,"), std::string::npos);
  const Json json = stability_json(results, {"driver", "device"}, kNearest);
  EXPECT_EQ(json["sweeps"][0]["curves"][0]["points"].back()["value"], "nan");
  EXPECT_TRUE(json["sweeps"][0]["curves"][0]["points"][0]["value"].is_null());
  EXPECT_NE(stability_script(results[0], "device", StabilityFile::svg).find("not finite"), std::string::npos);
}

TEST(Stability, ACancelledRunIsNotSaidToHold) {
  const std::atomic<bool> cancel{true};
  const SweepResult r = run_sweep(sweep("far-plane"), {.limits = everything()}, nothing_lost, nullptr, cancel);
  EXPECT_GT(r.left, 0u);
  EXPECT_FALSE(r.holds());
}

// A measurement that counts itself, and says what no renderer would: so a number that comes back came from the journal.
struct CountedMeasure {
  int made = 0;
  MeasureFn fn() {
    return [this](const SweepSetup& s) {
      Errors e;
      e.position_max = s.settings.camera.near == 3 ? kNan : s.settings.camera.near == 10 ? kNoEnd : 1.0 / ++made;
      return Measured{e, {}};
    };
  }
};

void expect_same_points(const SweepResult& a, const SweepResult& b) {
  EXPECT_EQ(stability_csv({a}), stability_csv({b}));
  EXPECT_EQ(stability_json({a}, {}, kNearest), stability_json({b}, {}, kNearest));
}

TEST(StabilityJournal, APointThatIsInItIsNotMeasuredAgain) {
  const TemporaryFolder folder("points");
  const std::atomic<bool> never{false};
  CountedMeasure measure;
  Journal journal(folder / "points.jsonl", "this program");
  const SweepRun how{.limits = everything(), .journal = &journal};
  const SweepResult first = run_sweep(sweep("near-plane"), how, measure.fn(), nullptr, never);
  const int made = measure.made;
  EXPECT_GT(made, 10);
  Journal again(folder / "again.jsonl", "this program");
  for (const StudyRow& row : journal.rows()) again.append(row);
  const SweepResult second =
      run_sweep(sweep("near-plane"), {.limits = everything(), .journal = &again}, measure.fn(), nullptr, never);
  EXPECT_EQ(measure.made, made);
  expect_same_points(first, second);
}

TEST(StabilityJournal, WhatWasStoppedGoesOnAndEndsAsIfItHadNot) {
  const TemporaryFolder folder("points-stopped");
  Journal journal(folder / "points.jsonl", "this program");
  const SweepRun how{.limits = everything(), .journal = &journal};
  std::atomic<bool> stop{false};
  CountedMeasure measure;
  const auto progress = [&](const Sweep&, size_t done, size_t) { stop = done >= 7; };
  const SweepResult stopped = run_sweep(sweep("near-plane"), how, measure.fn(), progress, stop);
  EXPECT_EQ(journal.rows().size(), 7u);
  EXPECT_FALSE(stopped.holds());
  for (const CurveResult& c : stopped.curves) EXPECT_TRUE(c.judged.empty()) << c.curve;
  const std::atomic<bool> never{false};
  const SweepResult whole = run_sweep(sweep("near-plane"), how, measure.fn(), nullptr, never);
  CountedMeasure fresh;
  expect_same_points(whole, run_sweep(sweep("near-plane"), {.limits = everything()}, fresh.fn(), nullptr, never));
}

// A sweep of which nothing is measured has no chart, and proves nothing.
TEST(StabilityJournal, FilesOfASweepWithoutPointsAreWritten) {
  const TemporaryFolder folder("points-none");
  const std::atomic<bool> cancel{true};
  const std::vector<SweepResult> results = {
      run_sweep(sweep("volume-level"), {.limits = everything()}, nothing_lost, nullptr, cancel),
      run_sweep(sweep("cull-families"), {.limits = everything()}, nothing_lost, nullptr, cancel)};
  EXPECT_NO_THROW(write_stability_files(folder / "out", results, {"driver", "device"}, kNearest));
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "stability.md"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "volume-level.svg"));
}

TEST(StabilityJournal, ShardsTogetherAreTheWhole) {
  const TemporaryFolder folder("points-shards");
  const std::atomic<bool> never{false};
  const auto position = [](const SweepSetup& s) {
    Errors e;
    e.position_max = s.settings.camera.near;
    return Measured{e, {}};
  };
  Journal all(folder / "all.jsonl", "this program");
  for (const size_t index : {1, 2, 3}) {
    Journal part(folder / fmt::format("{}.jsonl", index), "this program");
    const SweepRun how{.limits = everything(), .shard = {index, 3}, .journal = &part};
    EXPECT_GT(run_sweep(sweep("near-plane"), how, position, nullptr, never).left, 0u);
    for (const StudyRow& row : part.rows()) {
      EXPECT_FALSE(all.has(row.key)) << "two shards measured " << row.key;
      all.append(row);
    }
  }
  const auto none = [](const SweepSetup&) -> Measured {
    throw Error(ExitCode::unfinished, "test", "a point is missing");
  };
  const SweepResult merged =
      run_sweep(sweep("near-plane"), {.limits = everything(), .journal = &all}, none, nullptr, never);
  expect_same_points(merged, run_sweep(sweep("near-plane"), {.limits = everything()}, position, nullptr, never));
}

TEST(Stability, SharesOfAFamilyCountItsConfigurationsOnly) {
  CurveResult c;
  const auto add = [&](double x, double value, double lost, double lit) {
    SweepRow r{.x = x, .value = value, .lit_pixels = lit};
    r.errors.lost_pixels = lost, r.errors.max_linear = value;
    c.rows.push_back(r);
  };
  add(0, 0, 0, 100), add(1, 0.5, 50, 100), add(1000, kNoEnd, 1, 1);
  const FamilyShares a = family_shares(c, 0), b = family_shares(c, 1);
  EXPECT_EQ(a.configurations, 2u);
  EXPECT_DOUBLE_EQ(a.wrong, 0.5);
  EXPECT_DOUBLE_EQ(a.lost, 0.25);
  EXPECT_DOUBLE_EQ(a.worst_linear, 0.5);
  EXPECT_TRUE(std::isinf(b.worst_linear));
  EXPECT_EQ(family_shares(c, 2).configurations, 0u);
}

}  // namespace
}  // namespace gbl
