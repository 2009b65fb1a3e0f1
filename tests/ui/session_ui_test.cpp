// Two windows one after the other: the second goes on where the first was closed.
#include <fstream>

#include "tests/test_support.h"
#include "tests/ui/window_desk.h"

namespace gbl {
namespace {

TEST(Window, goes_on_where_it_was_left_with_its_bookmarks) {
  const TemporaryFolder state("window-session");
  Settings start, left;
  {
    WindowDesk desk({}, state.path());
    SKIP_WITHOUT_WINDOW(desk);
    start = desk.figure().settings;
    for (const char* key : {"n", "2"}) desk.press(key);
    desk.press("ctrl+shift+4");
    for (const char* key : {"c", "3"}) desk.press(key);
    left = desk.figure().settings;
    ASSERT_NE(left, start);
    EXPECT_EQ(desk.close(), 0);
  }
  {
    WindowDesk desk({}, state.path());
    SKIP_WITHOUT_WINDOW(desk);
    EXPECT_EQ(desk.figure().settings, left);
    desk.press("ctrl+4");
    const Figure kept = desk.figure();
    desk.keep("bookmark-4", kept);
    EXPECT_EQ(kept.settings.view.main, "albedo");
    EXPECT_EQ(kept.settings.lights.cull, start.lights.cull);
    EXPECT_NE(kept.settings.normal.encoding, start.normal.encoding);
    desk.press("Home");
    Settings home = desk.figure().settings;
    home.size = start.size;
    EXPECT_EQ(home, start);
  }
  WindowDesk desk({"--fresh"}, state.path());
  SKIP_WITHOUT_WINDOW(desk);
  EXPECT_EQ(desk.figure().settings, start);
}

TEST(Window, a_talk_leaves_the_session_as_it_was) {
  const TemporaryFolder state("window-talk");
  Settings left;
  {
    WindowDesk desk({}, state.path());
    SKIP_WITHOUT_WINDOW(desk);
    desk.press("n");
    left = desk.figure().settings;
    EXPECT_EQ(desk.close(), 0);
  }
  {
    WindowDesk desk({"--lesson", "three-ways-to-lose-a-light"}, state.path());
    SKIP_WITHOUT_WINDOW(desk);
    EXPECT_NE(desk.figure().settings, left);
    EXPECT_EQ(desk.close(), 0);
  }
  WindowDesk desk({}, state.path());
  SKIP_WITHOUT_WINDOW(desk);
  EXPECT_EQ(desk.figure().settings, left);
}

TEST(Window, opens_afresh_over_a_damaged_session_and_keeps_it) {
  const TemporaryFolder state("window-damaged");
  const std::filesystem::path file = state / "gbufferlab" / "session.json";
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "{\"version\": 1, \"last\":";
  WindowDesk desk({}, state.path());
  SKIP_WITHOUT_WINDOW(desk);
  desk.press("n");
  desk.keep("session-damaged", desk.figure());
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".bad"));
  EXPECT_EQ(desk.close(), 0);
  EXPECT_TRUE(std::filesystem::exists(file));
}

// Nothing below a file can be made, whoever runs the test.
TEST(Window, goes_on_where_no_session_can_be_written) {
  const TemporaryFolder folder("window-unwritable");
  std::ofstream(folder / "file") << "no folder";
  WindowDesk desk({}, folder / "file");
  SKIP_WITHOUT_WINDOW(desk);
  const Settings before = desk.figure().settings;
  desk.press("n");
  EXPECT_NE(desk.figure().settings, before);
  EXPECT_EQ(desk.close(), 0);
}

}  // namespace
}  // namespace gbl
