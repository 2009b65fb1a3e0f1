// What one window leaves to the next: written and read back, and every way in which the file can be wrong.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/session_keeper.h"
#include "app/start.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/options/presets.h"
#include "tests/disk_room.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

Session some_session() {
  Session s;
  s.last = ui::Snapshot{preset("nclgl").make(), true};
  s.last->settings.size = {800, 450};
  s.bookmarks[0] = ui::Snapshot{preset("learnopengl").make(), false};
  s.bookmarks[8] = ui::Snapshot{preset("start").make(), true};
  s.bookmarks[8]->settings.camera.position = {0.1, -1e-9, 12345.678};
  s.recent = {"/models/a b.glb", "/rigs/ü.json"};
  return s;
}

TEST(Session, IsReadAsItWasWritten) {
  const Session s = some_session();
  EXPECT_EQ(parse_session(session_text(s), "session"), s);
  EXPECT_EQ(parse_session(session_text({}), "session"), Session{});
}

// The next window trusts its session, so nothing gets in that this one was not asked to run.
TEST(Session, ALayoutFileThatNobodyAskedForIsNotKept) {
  Session s = some_session();
  s.last->settings.layout_file = "/elsewhere/sent.glsl@0123456789abcdef";
  s.bookmarks[0]->settings.layout_file = "/here/mine.glsl@0123456789abcdef";
  allow_layout_file("/here/mine.glsl");
  const Session again = parse_session(session_text(s), "session");
  EXPECT_EQ(again.last->settings.layout_file, "");
  EXPECT_EQ(again.bookmarks[0]->settings.layout_file, "/here/mine.glsl@0123456789abcdef");
}

TEST(Session, FilesAreWrittenAsAbsolutePaths) {
  Session s = some_session();
  s.last->settings.scene = "models/x.glb";
  s.bookmarks[0]->settings.lights.rig = "rig.json";
  const Session again = parse_session(session_text(s), "session");
  EXPECT_EQ(again.last->settings.scene, fs::current_path() / "models/x.glb");
  EXPECT_EQ(again.bookmarks[0]->settings.lights.rig, fs::current_path() / "rig.json");
  EXPECT_EQ(again.bookmarks[0]->settings.scene, s.bookmarks[0]->settings.scene) << "built-in scenes are no files";
}

TEST(Session, RecentFilesAreTheTenNewestAndEachStandsOnce) {
  std::vector<std::string> recent;
  for (int i = 0; i < 12; ++i) remember(recent, "/m/" + std::to_string(i) + ".glb");
  remember(recent, "/m/x/../5.glb");
  EXPECT_EQ(recent.size(), kMostRecent);
  EXPECT_EQ(recent[0], "/m/5.glb");
  EXPECT_EQ(recent[1], "/m/11.glb");
  EXPECT_EQ(std::count(recent.begin(), recent.end(), "/m/5.glb"), 1);
  remember(recent, "/m/\xff.glb");  // JSON cannot hold it
  EXPECT_EQ(recent[0], "/m/5.glb");
}

// Each names the file and what is wrong, and nothing of it is used.
TEST(Session, DamagedOnesAreRefusedWithTheirPlace) {
  const std::string good = session_text(some_session());
  for (size_t end = 0; end + 2 < good.size(); end += good.size() / 40)
    EXPECT_NE(error_line(ExitCode::bad_input, [&] { parse_session(good.substr(0, end), "s.json"); }).find("s.json"),
              std::string::npos);
  const auto refused = [](const char* text) {
    return error_line(ExitCode::bad_input, [&] { parse_session(text, "s.json"); });
  };
  EXPECT_PRED2(contains, refused(R"([])"), "object");
  EXPECT_PRED2(contains, refused(R"({})"), "version");
  EXPECT_PRED2(contains, refused(R"({"version": 99})"), "newer program");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "lasst": {}})"), "did you mean 'last'");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "last": {"large": true}})"), "last: \"settings\" are missing");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "last": {"settings": {"version": 1}}})"), "large");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "last": {"large": true, "settings": {"version": 99}}})"), "newer");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "bookmarks": {"10": {}}})"), "\"10\" is not one of 1 to 9");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "bookmarks": []})"), "bookmarks");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "recent": [3]})"), "recent: 3");
  EXPECT_PRED2(contains, refused(R"({"version": 1, "recent": {}})"), "recent");
}

class Keeper : public testing::Test {
 protected:
  TemporaryFolder folder_{"session"};
  const fs::path file_ = folder_ / "a" / "gbufferlab" / "session.json";
  const fs::path bad_ = file_.string() + ".bad";
};

TEST_F(Keeper, WritesWhatChangedAfterAPauseInFoldersOfItsOwn) {
  SessionKeeper keeper(file_);
  EXPECT_EQ(keeper.found(), Session{});
  const Session s = some_session();
  EXPECT_TRUE(keeper.due(0));
  keeper.keep(s, 0);
  EXPECT_EQ(keeper.take_trouble(), "");
  EXPECT_EQ(SessionKeeper(file_).found(), s);
  EXPECT_EQ(fs::status(file_.parent_path().parent_path()).permissions(), fs::perms::owner_all);
  EXPECT_FALSE(keeper.due(1));
  EXPECT_TRUE(keeper.due(10));
  fs::remove(file_);
  keeper.keep(s, 10);
  EXPECT_FALSE(fs::exists(file_)) << "nothing has changed: nothing is written";
}

TEST_F(Keeper, ADamagedFileIsPutAsideAndSaid) {
  fs::create_directories(file_.parent_path());
  for (const char* text : {"", "{\"version\"", "{\"version\": 99}", "no JSON at all"}) {
    write(file_, text);
    SessionKeeper keeper(file_);
    EXPECT_EQ(keeper.found(), Session{});
    const std::string trouble = keeper.take_trouble();
    EXPECT_PRED2(contains, trouble, file_.string());
    EXPECT_PRED2(contains, trouble, "kept as " + bad_.string());
    EXPECT_EQ(keeper.take_trouble(), "") << "said once";
    EXPECT_EQ(text_of(bad_), text);
    keeper.keep(some_session(), 0);
    EXPECT_EQ(SessionKeeper(file_).found(), some_session());
  }
}

TEST_F(Keeper, WhatCannotBePutAsideIsNotWrittenOver) {
  fs::create_directories(bad_ / "in the way");
  write(file_, "{\"version\": 99}");
  SessionKeeper keeper(file_);
  EXPECT_PRED2(contains, keeper.take_trouble(), "will not be remembered");
  EXPECT_FALSE(keeper.due(100));
  keeper.keep(some_session(), 100);
  EXPECT_EQ(text_of(file_), "{\"version\": 99}");
}

TEST_F(Keeper, WhatIsNoFileIsNotWaitedFor) {
  fs::create_directories(file_);  // a folder; a pipe would block whoever opens it
  SessionKeeper keeper(file_);
  EXPECT_PRED2(contains, keeper.take_trouble(), "is not a file");
  EXPECT_TRUE(fs::is_directory(bad_));
}

TEST_F(Keeper, AFolderThatCannotBeMadeIsSaidOnceAndTriedAgain) {
  write(folder_ / "a", "a file where a folder should be");
  SessionKeeper keeper(file_);
  keeper.take_trouble();
  keeper.keep(some_session(), 0);
  EXPECT_PRED2(contains, keeper.take_trouble(), "this window is not remembered: ");
  keeper.keep(some_session(), 10);
  EXPECT_EQ(keeper.take_trouble(), "");
  fs::remove(folder_ / "a");
  keeper.keep(some_session(), 20);
  EXPECT_EQ(SessionKeeper(file_).found(), some_session());
}

TEST_F(Keeper, OnAFullDiskTheLastSessionStaysAndTheNextOneIsKeptWhenThereIsRoom) {
  SessionKeeper keeper(file_);
  keeper.keep({.recent = {"/models/a.glb"}}, 0);
  const std::string before = text_of(file_);
  for (const size_t most : {0, 100}) {
    const DiskRoom room(most);
    keeper.keep(some_session(), 10);
    EXPECT_EQ(text_of(file_), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(file_.parent_path()), {}), 1) << "nothing half stays";
  }
  EXPECT_PRED2(contains, keeper.take_trouble(), "this window is not remembered: " + file_.string() + ": cannot be");
  keeper.keep(some_session(), 20);
  EXPECT_EQ(SessionKeeper(file_).found(), some_session());
}

TEST(SessionFile, StandsWhereXdgSays) {
  const auto at = [](const char* state, const char* home) {
    state ? setenv("XDG_STATE_HOME", state, 1) : unsetenv("XDG_STATE_HOME");
    home ? setenv("HOME", home, 1) : unsetenv("HOME");
    return session_file().value_or("none").string();
  };
  EXPECT_EQ(at("/s", "/h"), "/s/gbufferlab/session.json");
  EXPECT_EQ(at("relative", "/h"), "/h/.local/state/gbufferlab/session.json") << "XDG: to be ignored";
  EXPECT_EQ(at("", "/h"), "/h/.local/state/gbufferlab/session.json");
  EXPECT_EQ(at(nullptr, nullptr), "none");
}

class StartOf : public Keeper {
 protected:
  Start start(std::vector<const char*> words) {
    words.insert(words.begin(), {"gbufferlab", "view"});
    SessionKeeper keeper(file_);
    Start s = start_of(parse_arguments(static_cast<int>(words.size()), words.data()).value(), keeper);
    trouble_ = keeper.take_trouble();
    return s;
  }
  void leave(const std::string& scene, const std::string& rig = "") {
    Session s = some_session();
    s.last->settings.scene = scene;
    s.last->settings.lights.rig = rig;
    SessionKeeper(file_).keep(s, 0);
  }
  std::string trouble_;
};

TEST_F(StartOf, GoesOnOnlyWhereTheCommandLineSaysNothingOfWhatIsShown) {
  leave("builtin:room");
  const Start on = start({});
  ASSERT_TRUE(on.left);
  EXPECT_EQ(on.left->settings.scene, "builtin:room");
  EXPECT_TRUE(on.left_scene);
  EXPECT_EQ(on.asked.settings, preset("start").make()) << "Home";
  EXPECT_TRUE(start({"--without", "compute"}).left);
  const std::vector<const char*> others[] = {{"--fresh"},
                                             {"--present"},
                                             {"--scene", "builtin:hall"},
                                             {"--preset", "nclgl"},
                                             {"--set", "exposure=2"},
                                             {"--lights", "3"},
                                             {"--seed", "2"},
                                             {"--time", "1"},
                                             {"--camera", "1,2,3:0,0"},
                                             {"--size", "64x36"},
                                             {"--lesson", "three-ways-to-lose-a-light"}};
  for (const auto& words : others) EXPECT_FALSE(start(words).left) << words[0];
}

TEST_F(StartOf, ASessionWhoseFilesAreGoneIsPutAside) {
  for (const auto& [scene, rig] : {std::pair("/gone/model.glb", ""), std::pair("builtin:room", "/gone/rig.json"),
                                   std::pair("builtin:no-such-scene", "")}) {
    leave(scene, rig);
    const Start s = start({});
    EXPECT_FALSE(s.left);
    EXPECT_EQ(s.asked.settings, preset("start").make());
    EXPECT_PRED2(contains, trouble_, "The window starts afresh");
    EXPECT_TRUE(fs::exists(bad_));
    EXPECT_FALSE(fs::exists(file_));
    fs::remove(bad_);
  }
}

}  // namespace
}  // namespace gbl
