#include "renderer/study/study.h"

#include <chrono>
#include <gtest/gtest.h>
#include <set>
#include <thread>

#include "renderer/base/files.h"
#include "renderer/base/made_by.h"
#include "renderer/study/row_json.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

// n cases that differ in their lights.
StudyPlan plan_of(int n) {
  StudyPlan plan{"counting", {}, {}};
  for (int i = 0; i < n; ++i) {
    StudyCase c{"lights=" + std::to_string(i), {}, {{"lights", i}}};
    c.settings.lights.count = i;
    plan.cases.push_back(c);
  }
  return plan;
}

const std::atomic<bool> kOn{false};
MeasuredColumns measure(const StudyCase& c) { return {{{"draw_calls", c.settings.lights.count}}, c.settings}; }
MeasuredColumns measure_but_the_third(const StudyCase& c) {
  if (c.settings.lights.count == 2) throw Error(ExitCode::unfinished, "lighting", "no memory");
  return measure(c);
}

struct Desk {
  TemporaryFolder folder{"study"};
  Journal journal{folder / "rows.jsonl"};
};

TEST(RunStudy, ARowSaysWhoseItIs) {
  Desk desk;
  const StudyPlan plan = plan_of(2);
  const StudyCounts counts = run_study(plan, {}, desk.journal, measure, {}, kOn);
  EXPECT_EQ(counts.measured, 2u);
  EXPECT_EQ(counts.failed + counts.before + counts.left, 0u);
  const StudyCase& c = plan.cases[1];
  const StudyRow expected{"counting", "lights=1",          row_key(c.settings), {{"lights", 1}},
                          {},         {{"draw_calls", 1}}, c.settings,          made_by()};
  EXPECT_TRUE(desk.journal.rows().at(1) == expected);
}

TEST(RunStudy, AFailureIsARowAndTheStudyGoesOn) {
  Desk desk;
  const StudyCounts counts = run_study(plan_of(4), {}, desk.journal, measure_but_the_third, {}, kOn);
  EXPECT_EQ(counts.measured, 3u);
  EXPECT_EQ(counts.failed, 1u);
  const StudyRow& row = desk.journal.rows().at(2);
  EXPECT_EQ(row.failed, "lighting: no memory");
  EXPECT_EQ(row.settings.lights.count, 2);
  EXPECT_TRUE(row.at == (std::vector<Assignment>{{"lights", 2}}));

  const auto no_memory = [](const StudyCase&) -> MeasuredColumns { throw std::bad_alloc(); };
  EXPECT_EQ(run_study(plan_of(3), {}, desk.journal, no_memory, {}, kOn).failed, 1u) << "the two others are there";
}

// Its pictures, where there is no room: all other rows would fail as well, each after its work.
TEST(RunStudy, WhatCannotBeWrittenEndsIt) {
  Desk desk;
  const auto no_room = [](const StudyCase& c) -> MeasuredColumns {
    if (c.settings.lights.count == 1) throw CannotWrite("thumbs/a.jpg", "no room");
    return measure(c);
  };
  const std::string line =
      error_line(ExitCode::unfinished, [&] { run_study(plan_of(4), {}, desk.journal, no_room, {}, kOn); });
  EXPECT_TRUE(contains(line, "thumbs/a.jpg: cannot be written: no room")) << line;
  EXPECT_EQ(desk.journal.rows().size(), 1u);
}

TEST(RunStudy, SkipsWhatIsThereAndTriesAgainWhatFailed) {
  Desk desk;
  run_study(plan_of(4), {}, desk.journal, measure_but_the_third, {}, kOn);
  std::vector<std::string> asked;
  const auto noted = [&](const StudyCase& c) { return asked.push_back(c.id), measure(c); };
  const StudyCounts counts = run_study(plan_of(5), {}, desk.journal, noted, {}, kOn);
  EXPECT_EQ(counts.before, 3u);
  EXPECT_EQ(counts.measured, 2u);
  EXPECT_EQ(asked, (std::vector<std::string>{"lights=2", "lights=4"}));
  ASSERT_EQ(desk.journal.rows().size(), 5u);
  EXPECT_FALSE(desk.journal.rows()[2].failed);
}

// The clock is asked between rows: a budget of nothing measures nothing, and the next run goes on.
TEST(RunStudy, StopsWhenItsTimeIsUpAndGoesOnLater) {
  Desk desk;
  const StudyCounts none = run_study(plan_of(4), {}, desk.journal, measure, {}, kOn, 0.0);
  EXPECT_EQ(none.measured, 0u);
  EXPECT_EQ(none.left, 4u);
  const auto slow = [](const StudyCase& c) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    return measure(c);
  };
  const StudyCounts one = run_study(plan_of(4), {}, desk.journal, slow, {}, kOn, 0.02);
  EXPECT_EQ(one.measured, 1u) << "a row that was begun is finished";
  EXPECT_EQ(one.left, 3u);
  EXPECT_EQ(run_study(plan_of(4), {}, desk.journal, measure, {}, kOn, 1000.0).measured, 3u);
}

TEST(RunStudy, ShardsTakeEachCaseExactlyOnce) {
  const StudyPlan plan = plan_of(11);
  for (size_t n = 1; n <= 13; ++n) {
    std::multiset<std::string> seen;
    for (size_t i = 1; i <= n; ++i) {
      Desk desk;
      const auto noted = [&](const StudyCase& c) { return seen.insert(c.id), measure(c); };
      run_study(plan, {i, n}, desk.journal, noted, {}, kOn);
    }
    EXPECT_EQ(seen.size(), plan.cases.size()) << n;
    for (const StudyCase& c : plan.cases) EXPECT_EQ(seen.count(c.id), 1u) << n;
  }
}

TEST(RunStudy, StopsBetweenRowsWhenCancelled) {
  Desk desk;
  std::atomic<bool> cancel{false};
  const auto second_cancels = [&](const StudyCase& c) { return cancel = c.settings.lights.count == 1, measure(c); };
  const StudyCounts counts = run_study(plan_of(5), {}, desk.journal, second_cancels, {}, cancel);
  EXPECT_EQ(counts.measured, 2u) << "the row that was begun is kept";
  EXPECT_EQ(counts.left, 3u);
  EXPECT_EQ(desk.journal.rows().size(), 2u);
}

TEST(RunStudy, AnInterruptedRowIsNoFailure) {
  Desk desk;
  const auto interrupted = [](const StudyCase& c) -> MeasuredColumns {
    if (c.settings.lights.count == 1) throw Error(ExitCode::interrupted, "", "stopped");
    return measure(c);
  };
  const StudyCounts counts = run_study(plan_of(5), {}, desk.journal, interrupted, {}, kOn);
  EXPECT_EQ(counts.failed, 0u);
  EXPECT_EQ(counts.left, 4u);
  EXPECT_EQ(desk.journal.rows().size(), 1u);
}

TEST(RunStudy, TellsHowFarItIs) {
  Desk desk;
  run_study(plan_of(1), {}, desk.journal, measure, {}, kOn);
  std::vector<StudyProgress> told;
  const StudyPlan plan = plan_of(4);  // what is told points into it
  run_study(
      plan, {}, desk.journal, measure_but_the_third, [&](const StudyProgress& p) { told.push_back(p); }, kOn);
  ASSERT_EQ(told.size(), 4u);  // before each of three, and at the end
  EXPECT_EQ(told[0].done, 1u);
  EXPECT_EQ(told[0].total, 4u);
  EXPECT_FALSE(told[0].seconds_left) << "nothing measured yet: unknown, not zero";
  EXPECT_EQ(told[0].next->id, "lights=1");
  ASSERT_TRUE(told[1].seconds_left);
  EXPECT_GE(*told[1].seconds_left, 0);
  EXPECT_EQ(told[3].done, 4u);
  EXPECT_EQ(told[3].failed, 1u);
  EXPECT_EQ(told[3].seconds_left, 0);
  EXPECT_EQ(told[3].next, nullptr);
}

TEST(ParseShard, ReadsAndRefuses) {
  EXPECT_EQ(parse_shard("2/3").index, 2u);
  EXPECT_EQ(parse_shard("2/3").of, 3u);
  EXPECT_EQ(parse_shard("1/1").of, 1u);
  for (const char* text : {"", "2", "/3", "2/", "2/3x", "a/b", "-1/3", "1.5/3", "2 / 3"}) {
    const std::string line = error_line(ExitCode::bad_input, [&] { parse_shard(text); });
    EXPECT_TRUE(contains(line, "--shard") && contains(line, "write i/n")) << line;
  }
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [] { parse_shard("0/3"); }), "count from 1"));
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [] { parse_shard("4/3"); }), "beyond the last"));
  EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [] { parse_shard("1/0"); }), "beyond the last"));
}

}  // namespace
}  // namespace gbl
