// Ctrl+O in a real window: a path is typed and completed, and what it names is opened.
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"
#include "tests/test_support.h"
#include "tests/ui/window_desk.h"

namespace gbl {
namespace {

TEST(Window, opens_a_picture_by_its_path_and_lists_it_afterwards) {
  const TemporaryFolder folder("window-path");
  Settings kept = preset("nclgl").make();
  write_png(folder / "kept-picture.png", {{1, 1}, {1, 2, 3, 255}}, {{kSettingsKey, settings_text(kept)}});
  std::filesystem::create_directories(folder / "kept-folder");
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  const Settings before = desk.figure().settings;
  desk.press("ctrl+o");
  desk.type((folder / "kept-p").string());
  desk.press("Tab");
  desk.keep("path", desk.figure());
  desk.press("Return");
  Settings now = desk.figure().settings;
  kept.size = now.size;
  EXPECT_EQ(now, kept);
  EXPECT_NE(now, before);
  desk.press("Home");
  EXPECT_EQ(desk.figure().settings, before);
  desk.press("ctrl+o");
  desk.press("Down");
  desk.keep("path-recent", desk.figure());
  desk.press("Return");
  EXPECT_EQ(desk.figure().settings, kept) << "the newest of those that were opened lately";
}

}  // namespace
}  // namespace gbl
