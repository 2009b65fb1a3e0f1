// Windows one after the other and two at once: what one leaves to the next.
#include <chrono>
#include <fstream>
#include <thread>

#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "tests/test_support.h"
#include "tests/ui/window_desk.h"

namespace gbl {
namespace {

// Of the window that the session tells of; the file must be whole.
Settings kept_in(const std::filesystem::path& session) {
  const Json json = parse_json(read_text_file(session), session.string());
  return parse_settings(json.at("last").at("settings").dump(), session.string());
}

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

TEST(Window, goes_on_as_near_as_another_driver_comes) {
  const TemporaryFolder state("window-nearest");
  Settings left;
  {
    WindowDesk desk({"--preset", "exact"}, state.path());
    SKIP_WITHOUT_WINDOW(desk);
    left = desk.figure().settings;
    EXPECT_EQ(desk.close(), 0);
  }
  WindowDesk desk({"--without", "clip-control"}, state.path());
  SKIP_WITHOUT_WINDOW(desk);
  const Figure near = desk.figure();
  desk.keep("session-nearest", near);
  Settings expected = left;
  expected.depth.format = DepthFormat::d32f;
  EXPECT_EQ(near.settings, expected);
  EXPECT_FALSE(std::filesystem::exists(state / "gbufferlab" / "session.json.bad"));
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

TEST(Window, ends_in_its_own_words_when_the_display_goes_and_its_session_stays) {
  const TemporaryFolder state("window-display");
  const std::filesystem::path file = state / "gbufferlab" / "session.json";
  WindowDesk desk({}, state.path());
  SKIP_WITHOUT_WINDOW(desk);
  desk.press("n");
  const Settings left = desk.figure().settings;
  const auto kept = [&] { return std::filesystem::exists(file) && kept_in(file) == left; };
  for (int k = 0; k < 20 && !kept(); ++k) std::this_thread::sleep_for(std::chrono::seconds(1));
  ASSERT_TRUE(kept()) << "it is written every few seconds";
  EXPECT_EQ(desk.lose_display(), static_cast<int>(ExitCode::unfinished));
  EXPECT_EQ(desk.said(),
            "gbufferlab: window: the display was lost; start it again, pictures that were saved are kept\n");
  EXPECT_TRUE(kept());
}

// Each writes what has changed in it; of two the last to do so is remembered.
TEST(Window, two_at_once_leave_a_session_of_one_of_them) {
  const TemporaryFolder state("window-two");
  const std::filesystem::path folder = state / "gbufferlab";
  Settings first, second;
  {
    WindowDesk one({}, state.path()), other({"--fresh"}, state.path());
    SKIP_WITHOUT_WINDOW(one);
    SKIP_WITHOUT_WINDOW(other);
    for (const char* key : {"n", "c", "n"}) one.press(key), other.press("c");
    first = one.figure().settings, second = other.figure().settings;
    ASSERT_NE(first, second);
    EXPECT_EQ(one.close(), 0);
    EXPECT_EQ(other.close(), 0);
  }
  const Settings kept = kept_in(folder / "session.json");
  EXPECT_TRUE(kept == first || kept == second);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_EQ(entry.path().extension(), ".json") << "nothing half stays";
}

}  // namespace
}  // namespace gbl
