// Ctrl+1…9 and Ctrl+Shift+1…9.
#include <gtest/gtest.h>

#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

void go(Desk& desk, const char* key) { desk.press(key, false, true); }
void keep(Desk& desk, const char* key) { desk.press(key, true, true); }

TEST(Bookmarks, AnEmptyOneKeepsWhatIsShownAndAFullOneBringsItBack) {
  Desk desk;
  desk.press("c");
  const Settings kept = desk.settings;
  go(desk, "3");
  EXPECT_EQ(desk.settings, kept);
  desk.press("b"), desk.press("2");
  ASSERT_NE(desk.settings, kept);
  desk.settings.size = {640, 360};  // the window has become smaller since
  go(desk, "3");
  EXPECT_EQ(desk.settings.size, glm::ivec2(640, 360)) << "the window's";
  desk.settings.size = kept.size;
  EXPECT_EQ(desk.settings, kept);
  EXPECT_GT(desk.visible(), 1) << "all views, as when it was kept";
  go(desk, "4");
  EXPECT_EQ(desk.settings, kept) << "4 was empty still";
}

TEST(Bookmarks, WithShiftTheOldOneIsReplaced) {
  Desk desk;
  go(desk, "1");
  desk.press("2");
  desk.press("n");
  const Settings second = desk.settings;
  keep(desk, "1");
  desk.press("Home");
  ASSERT_NE(desk.settings, second);
  go(desk, "1");
  EXPECT_EQ(desk.settings, second);
  EXPECT_EQ(desk.visible(), 1) << "the view that was alone is alone again";
}

TEST(Bookmarks, GoingThereIsOneStepBack) {
  Desk desk;
  go(desk, "9");
  desk.press("c"), desk.frame();
  desk.press("n"), desk.frame();
  const Settings before = desk.settings;
  go(desk, "9");
  ASSERT_NE(desk.settings, before);
  desk.frame();
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings, before);
}

TEST(Bookmarks, OneThatThisDeviceCannotDrawChangesNothing) {
  Desk desk;
  Bookmarks kept;
  kept[0] = Snapshot{desk.settings};
  for (const Option& o : options())  // the desk has no features
    for (const ValueRow& r : o.values)
      if (r.needs != Feature::none) o.set(kept[0]->settings, r.id, o);
  ASSERT_NE(kept[0]->settings, desk.settings);
  desk.ui.set_bookmarks(kept);
  const Settings before = desk.settings;
  go(desk, "1");
  EXPECT_EQ(desk.settings, before);
  EXPECT_EQ(desk.ui.bookmarks(), kept);
}

}  // namespace
}  // namespace gbl::ui
