// F11 in a real window.
#include "tests/ui/window_desk.h"

namespace gbl {
namespace {

TEST(Window, fills_the_screen_and_comes_back) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  constexpr glm::ivec2 kWindow{1200, 700}, kScreen{1600, 900};
  desk.resize(kWindow);
  ASSERT_EQ(desk.figure().picture.size, kWindow);
  desk.press("F11");
  const Figure full = desk.figure();
  desk.keep("full-screen-on", full);
  EXPECT_EQ(full.picture.size, kScreen);
  desk.press("F11");
  EXPECT_EQ(desk.figure().picture.size, kWindow);
}

}  // namespace
}  // namespace gbl
