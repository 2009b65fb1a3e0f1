#include "renderer/study/advice/advice_page.h"

#include <cmath>
#include <gtest/gtest.h>

#include "renderer/study/page/html_text.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

AdvisedSetup setup(LightMethod method, double cost) {
  AdvisedSetup s;
  s.settings.lights.method = method;
  s.cost = cost, s.bytes_per_pixel = 20;
  s.proof.worst = {.compared = 1000, .over = 1, .worst = 2 / 255.0};
  return s;
}

std::string command_of(const Settings& s) { return std::string("bench ") + row(s.lights.method).id; }

TEST(AdvicePage, MarksTheChosenOneAndListsWhatWasTried) {
  Advice advice;
  advice.best = setup(LightMethod::tiled, 3), advice.runner_up = setup(LightMethod::clustered, 4);
  advice.measured = {setup(LightMethod::volumes, 9), *advice.runner_up, *advice.best};
  advice.values = {{.values = {{"normal.encoding", "xyz8"}}, .holds = false}};
  advice.left_out = {"normal.encoding=xyz8: too coarse"};
  const Page page = advice_page(advice, {}, {"driver", "device"}, command_of);
  ASSERT_EQ(page.rows.size(), 4u) << "three measured, each once, and a value alone";
  EXPECT_TRUE(page.rows[0].marked);
  EXPECT_EQ(page.rows[0].command, "bench tiled");
  EXPECT_FALSE(page.rows[1].marked);
  EXPECT_EQ(page.rows[1].cells[0].text, "the runner-up");
  EXPECT_EQ(page.rows[3].cells[0].text, "alone, does not hold");
  ASSERT_EQ(page.charts[0].points.size(), 3u);
  EXPECT_EQ(page.charts[0].points[0].label, "chosen");
  EXPECT_TRUE(contains(page_html(page), "too coarse"));
}

TEST(AdvicePage, NeedsNoAnswer) {
  Advice advice;
  advice.stopped = true;
  const std::string html = page_html(advice_page(advice, {}, {}, command_of));
  EXPECT_TRUE(contains(html, "None has been measured") && contains(html, "Stopped before the answer"));
}

}  // namespace
}  // namespace gbl
