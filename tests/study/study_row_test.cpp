#include "renderer/study/study_row.h"

#include <gtest/gtest.h>

#include "renderer/base/json.h"

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

TEST(StudyRow, HasEveryErrorColumnAndNoneIsInvented) {
  FrameReport r;
  r.size = {640, 360};
  Timing t;
  t.pass_ms = {{"lighting", {3, 1, 2}}};
  t.frames = 3;
  const Json row = study_row(r, {}, t, {"driver", "device"});
  for (const ErrorColumn& c : error_columns()) {
    ASSERT_TRUE(row.contains(c.id)) << c.id;
    EXPECT_TRUE(row[c.id].is_null()) << c.id;
    EXPECT_GT(std::string(c.help).size(), 3u);
  }
  EXPECT_EQ(row["time_ms_lighting_median"], 2);
  EXPECT_EQ(row["frames"], 3);
  EXPECT_TRUE(row["pairs_lit"].is_null()) << "unknown is empty, never zero";
  EXPECT_EQ(row["size"], "640x360");
}

}  // namespace
}  // namespace gbl
