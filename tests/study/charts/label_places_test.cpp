#include "renderer/study/charts/label_places.h"

#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/study/charts/gnuplot.h"
#include "tests/study/study_rows.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

TEST(PlaceLabels, NoneLiesOnAMarkOrOnAnother) {
  const glm::dvec2 frame(850, 470);
  Pcg32 random(11);
  for (int round = 0; round < 20; ++round) {
    std::vector<ChartMark> marks;
    for (int i = 0; i < 265; ++i) marks.push_back({{random.in(0, frame.x), random.in(0, frame.y)}, 6});
    std::vector<LabelWish> wishes;
    for (size_t i = 0; i < 15; ++i) wishes.push_back({marks[i].at, 6, {110, 15}});
    const auto places = place_labels(frame, marks, wishes);
    std::vector<LabelBox> boxes;
    for (const ChartMark& m : marks) boxes.push_back({m.at - m.radius, m.at + m.radius});
    for (const auto& p : places) {
      ASSERT_TRUE(p) << "there is room for all of them";
      for (const LabelBox& b : boxes) EXPECT_FALSE(p->box.meets(b));
      EXPECT_TRUE(p->box.low.x >= 0 && p->box.low.y >= 0 && p->box.high.x <= frame.x && p->box.high.y <= frame.y);
      boxes.push_back(p->box);
    }
  }
}

TEST(PlaceLabels, StandsNextToALonelyMarkWithoutALine) {
  const ChartMark mark{{400, 200}, 6};
  const LabelWish wish{mark.at, 6, {60, 15}};
  const auto places = place_labels({850, 470}, std::span(&mark, 1), std::span(&wish, 1));
  ASSERT_TRUE(places[0]);
  EXPECT_FALSE(places[0]->line_to);
  EXPECT_LT(glm::distance(places[0]->box.middle(), mark.at), 20);
}

TEST(PlaceLabels, IsEmptyWhereThereIsNoRoom) {
  const ChartMark mark{{10, 10}, 10};
  const LabelWish wish{mark.at, 10, {60, 15}};
  EXPECT_FALSE(place_labels({20, 20}, std::span(&mark, 1), std::span(&wish, 1))[0]);
}

TEST(ChartTicks, OfSharesAreInPercent) {
  const ChartAxis axis = axis_for(chart_error_column("over_1_255_display"), {0, 0.01, 0.1});
  std::vector<std::string> labels;
  for (const ChartTick& t : ticks_of(axis)) labels.push_back(t.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"0", "1 %", "2 %", "5 %", "10 %"}));
  EXPECT_EQ(axis.along(0), axis.along(*axis.zero_at)) << "on the row of its own";
  EXPECT_GT(axis.along(0), 0);
  EXPECT_LT(axis.along(0), axis.along(0.01));
}

TEST(ChartScript, TellsSoundFromUnsound) {
  std::vector<StudyRow> rows = {test::row_of("a", {{"mib", 1.0}, {"over_1_255_display", 0.0}}),
                                test::row_of("b", {{"mib", 2.0}, {"over_1_255_display", 0.5}})};
  rows[1].settings.normal.encoding = NormalEncoding::xy_sqrt;
  ASSERT_FALSE(sound(rows[1].settings));
  const Chart chart = chart_points(rows, "mib", "over_1_255_display", "layout");
  EXPECT_TRUE(chart.points[0].sound);
  EXPECT_FALSE(chart.points[1].sound);
  const std::string script = chart_script(chart, {}, ChartFile::svg);
  for (const char* part :
       {"sound (filled)", "unsound (open)", "$S0 using 1:2 with points pt 7", "$U0 using 1:2 with points pt 6"})
    EXPECT_TRUE(contains(script, part)) << part;
  EXPECT_TRUE(contains(script, " %%'")) << "gnuplot takes a label for a format";
  EXPECT_TRUE(contains(script, "set object rectangle")) << "zero has a row of its own";
}

}  // namespace
}  // namespace gbl
