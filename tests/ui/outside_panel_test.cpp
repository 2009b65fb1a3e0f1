#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

TEST(OutsidePanel, AsksForAPictureFromWhereKeysAndMouseTakeIt) {
  Desk desk;
  desk.press("i", true);
  desk.frame();
  ASSERT_TRUE(desk.requests.outside);
  const OutsideRequest first = *desk.requests.outside;
  EXPECT_GT(first.size.x, 300);
  const Camera own = desk.settings.camera;
  desk.press("Right");
  desk.frame();
  EXPECT_NE(desk.requests.outside->from.position, first.from.position);
  desk.press("r");
  desk.frame();
  EXPECT_EQ(*desk.requests.outside, first) << "R: as at first";
  const double apart = glm::distance(first.from.position, own.position);
  desk.press("PgUp");
  desk.frame();
  EXPECT_LT(glm::distance(desk.requests.outside->from.position, own.position), apart);
  desk.press("t");
  desk.frame();
  EXPECT_LT(glm::distance(desk.requests.outside->from.position, own.position), 100 * own.near) << "the near plane";
  for (const auto& [x, down] : {std::pair(1200.0f, false), {1200.0f, true}, {1240.0f, true}, {1240.0f, false}})
    desk.point({x, 300}, down);
  EXPECT_EQ(desk.settings.camera, own) << "the frame's camera stays";
  desk.press("i", true);
  desk.frame();
  EXPECT_FALSE(desk.requests.outside) << "it costs nothing when it is closed";
}

}  // namespace
}  // namespace gbl::ui
