// A real window that gets random keys for a long time does not grow, stop or change. GBL_LONG_RUN_S=900: for a quarter of
// an hour.
#include <chrono>
#include <set>
#include <thread>

#include "renderer/base/random.h"
#include "renderer/options/settings_json.h"
#include "tests/flatness.h"
#include "tests/ui/window_desk.h"
#include "ui/keys.h"

namespace gbl {
namespace {

// How the window looks, which Home does not undo.
const std::set<std::string> kLeftOut = {"quit",  "theme",        "present",     "reticle",
                                        "timer", "figure.white", "full-screen", "ui.scale"};

// Before that the caches of programs and the driver's of their variants still fill: keys come more slowly than frames.
constexpr double kWarmUpS = 1200;

class LongWindow : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { test::draw_without_threads(); }
  static std::vector<std::string> keys() {
    std::vector<std::string> out;
    for (const ui::KeyRow& row : ui::key_rows())
      if (!kLeftOut.contains(row.id))
        for (const ui::KeyEvent& key : ui::presses_of(row)) {
          out.push_back(xdotool_name(key));
          if (!key.shift && !key.ctrl) out.push_back("shift+" + out.back());
        }
    return out;
  }
  void use_it() {
    constexpr glm::ivec2 kSizes[] = {{1280, 720}, {1000, 700}, {1600, 900}, {640, 480}};
    desk_.resize(kSizes[random_.next() % std::size(kSizes)]);
    for (int k = 0; k < 40; ++k) desk_.press(keys_[random_.next() % keys_.size()]);
    desk_.hold("w", 200);
  }
  // Nothing open, nothing compared, nothing kept of what was measured beside the pictures; -> the large picture.
  Figure at_home() {
    for (const char* key : {"Escape", "Escape", "Escape", "Escape", "Home", "ctrl+b", "o", "Escape"}) desk_.press(key);
    desk_.resize({1600, 900});
    for (const char* key : {"F5", "Home"}) desk_.press(key);
    constexpr std::chrono::seconds kMost(20);  // shaders are read again and pairs counted, on a busy machine
    return desk_.figure("F12", kMost);
  }
  // A key that comes and goes while a frame is drawn is lost: on a busy machine they are pressed again.
  Figure go_back(const Figure& first) {
    Figure now = at_home();
    for (int k = 0; k < 4 && !(now.settings == first.settings && now.picture == first.picture); ++k) now = at_home();
    return now;
  }
  void record() {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // it rests, and gives back what it does not need
    resident_mib_.push_back({seconds(), desk_.resident_mib()});
    fmt::print("{:10.0f}{:8}{:10.1f}\n", seconds(), resident_mib_.size() - 1, resident_mib_.back().value);
    std::fflush(stdout);
  }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  WindowDesk desk_{{"--fresh"}};
  Pcg32 random_{2026};
  std::vector<std::string> keys_ = keys();
  std::vector<test::Sample> resident_mib_;  // after each round
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

TEST_F(LongWindow, NeitherGrowsNorStopsNorChanges) {
  SKIP_WITHOUT_WINDOW(desk_);
  const Figure first = at_home();
  ASSERT_GT(first.picture.size.x, 0);
  desk_.keep("long-window-first", first);
  fmt::print("   seconds  rounds  resident MiB\n");
  const double most_s = test::long_run_s(60);
  do {
    use_it();
    const Figure now = go_back(first);
    record();
    ASSERT_TRUE(desk_.runs());
    ASSERT_EQ(desk_.said(), "") << "OpenGL's errors among it";
    ASSERT_GT(now.picture.size.x, 0) << "it does not answer";
    desk_.keep("long-window", now);
    ASSERT_EQ(settings_text(now.settings), settings_text(first.settings));
    ASSERT_TRUE(now.picture == first.picture)
        << "at the same settings, another picture: build/ci/window/long-window.png";
  } while (seconds() < most_s);
  fmt::print("resident {:+.2f} %\n", 100 * test::growth(resident_mib_));
  if (most_s >= kWarmUpS) {
    EXPECT_LE(test::growth(resident_mib_), 0.02);
  }
  EXPECT_EQ(desk_.close(), 0);
}

}  // namespace
}  // namespace gbl
