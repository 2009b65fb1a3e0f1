// A real window under Xvfb: every key of the table, sent as a user sends it.
#include <cctype>
#include <chrono>
#include <cstring>
#include <fstream>
#include <map>
#include <thread>

#include "renderer/lessons/lessons.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "tests/test_support.h"
#include "tests/ui/window_desk.h"
#include "ui/keys.h"

namespace gbl {
namespace {

// What must be on screen before a key can do anything.
const std::map<std::string, std::vector<std::string>> kBefore = {
    {"view.all", {"2"}},
    {"home", {"c"}},
    {"lesson.reveal", {"Next", "Return"}},
    {"close", {"F1"}},
    {"pixel.nudge", {"ctrl+g", "Return"}},
};

// What Home leaves: how the window looks, not what it shows.
const std::map<std::string, const char*> kAfter = {
    {"theme", "ctrl+t"}, {"present", "ctrl+shift+p"}, {"reticle", "F9"}, {"timer", "F10"}};

// Settings but for what a key may leave changed on purpose: the pick is no part of a picture.
Settings comparable(Settings s) {
  s.time_s = 0;
  return s;
}

// It took 0.15 of a processor while it drew four times a second.
TEST(Window, one_that_nobody_touches_uses_no_processor_and_wakes_at_a_key) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  desk.figure();
  for (int s = 0; s < 60; ++s) {  // until what is compiled and measured beside the picture has begun and ended
    const double began = desk.computed_s();
    std::this_thread::sleep_for(std::chrono::seconds(2));
    if (desk.computed_s() - began < 0.02 * 2) break;
  }
  const double before = desk.computed_s();
  std::this_thread::sleep_for(std::chrono::seconds(4));
  EXPECT_LT(desk.computed_s() - before, 0.02 * 4);
  desk.press("2");
  EXPECT_EQ(desk.figure().settings.view.main, "albedo");
}

TEST(Window, every_key_of_the_table_does_something_and_home_undoes_it) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  const Figure start = desk.figure();
  desk.keep("start", start);
  for (const ui::KeyRow& row : ui::key_rows()) {
    if (row.id.starts_with("figure")) continue;  // every step below presses it
    if (row.id == "quit") continue;              // session_ui_test.cpp
    if (row.id == "camera") continue;            // held keys: the test below
    for (const ui::KeyEvent& key : ui::presses_of(row)) {
      const auto before = kBefore.find(row.id);
      Figure from = start;
      if (before != kBefore.end()) {
        for (const std::string& k : before->second) desk.press(k);
        from = desk.figure();
      }
      desk.press(xdotool_name(key));
      const Figure now = desk.figure();
      desk.keep(row.id + "-" + xdotool_name(key), now);
      EXPECT_FALSE(now.picture == from.picture) << row.id << ": " << xdotool_name(key) << " changed nothing on screen";
      if (const auto after = kAfter.find(row.id); after != kAfter.end()) desk.press(after->second);
      for (const char* k : {"Escape", "Escape", "Escape", "Home"}) desk.press(k);
    }
  }
  const Figure end = desk.figure();
  EXPECT_EQ(comparable(end.settings), comparable(start.settings));
}

TEST(Window, an_axis_key_takes_the_next_row_and_shift_the_one_before) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  const Settings start = desk.figure().settings;
  for (const Option& o : options()) {
    if (o.kind != Kind::choice || std::string_view(o.key).size() != 1) continue;
    const std::string key(1, static_cast<char>(std::tolower(o.key[0])));
    Settings next = start;
    cycle(o, next, 1, FeatureSet{});
    desk.press(key);
    EXPECT_EQ(chosen(o, desk.figure().settings), chosen(o, next)) << o.path;
    desk.press("shift+" + key);
    EXPECT_EQ(chosen(o, desk.figure().settings), chosen(o, start)) << o.path;
  }
}

double mean_of_main_picture(const Image& screen) {
  double sum = 0;
  for (int y = 30; y < 440; ++y)  // below the badge, inside the frame
    for (int x = 10; x < 790; ++x) {
      const uint8_t* p = &screen.rgba[4u * (static_cast<size_t>(y) * screen.size.x + x)];
      sum += p[0] + p[1] + p[2];
    }
  return sum / (410.0 * 780 * 3);
}

TEST(Window, pressing_c_puts_a_pool_of_light_out_and_brings_it_back) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  const double start = mean_of_main_picture(desk.figure().picture);
  desk.press("c");
  const double back = mean_of_main_picture(desk.figure().picture);
  desk.press("shift+c");
  const double again = mean_of_main_picture(desk.figure().picture);
  EXPECT_LT(back, start - 5) << "of 255: two lights near the camera light half the picture";
  EXPECT_NEAR(again, start, 1e-9);
}

// F12 keeps the panel as it stands on screen, less the buttons on its upper edge, and what it shows can be had again.
TEST(Window, a_figure_is_the_panel_as_shown_and_brings_it_back) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  for (const char* key : {"4", "ctrl+m", "ctrl+m", "ctrl+v", "d"})
    desk.press(key);  // depth in colours, a footprint over it
  const Figure window = desk.figure(), panel = desk.figure("F12");
  ASSERT_GE(panel.picture.size.x, 800);
  ASSERT_GT(panel.picture.size.y, panel.picture.size.x * 9 / 16) << "the caption stands below";
  const auto differing = [](const Image& a, const Image& b, int from, int to) {
    size_t n = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < a.size.x; ++x)
        n +=
            std::memcmp(&a.rgba[4u * (static_cast<size_t>(y) * static_cast<size_t>(a.size.x) + static_cast<size_t>(x))],
                        &b.rgba[4u * (static_cast<size_t>(y) * static_cast<size_t>(b.size.x) + static_cast<size_t>(x))],
                        3) != 0;
    return n;
  };
  const int height = panel.picture.size.x * 9 / 16;
  EXPECT_EQ(differing(panel.picture, window.picture, 30, height), 0u);
  EXPECT_GT(differing(panel.picture, window.picture, 0, 30), 100u) << "the buttons are no part of it";
  EXPECT_EQ(panel.settings, window.settings);
  EXPECT_EQ(panel.settings.view.overlays.size(), 1u);
  desk.keep("panel", panel);
  EXPECT_EQ(desk.close(), 0);

  WindowDesk again({"--state", panel.file.string()});
  again.press("ctrl+v");  // as wide as it was
  const Figure back = again.figure("F12");
  EXPECT_EQ(back.settings, panel.settings);
  EXPECT_EQ(back.picture.size, panel.picture.size);
  EXPECT_EQ(differing(back.picture, panel.picture, 0, height), 0u);
}

TEST(Window, a_lesson_opens_at_a_step_and_shows_what_somebody_made_of_it) {
  const TemporaryFolder folder("window-step");
  const Lesson lesson = load_lesson("ten-minutes");
  Settings made = settings_at(lesson, 2);
  made.lights.count = 7;
  std::ofstream(folder / "made.json") << settings_text(made);
  WindowDesk desk({"--lesson", "ten-minutes:3", "--state", (folder / "made.json").string()});
  SKIP_WITHOUT_WINDOW(desk);
  const Figure opened = desk.figure();
  made.size = opened.settings.size, made.view = opened.settings.view;
  EXPECT_EQ(opened.settings, made);
  desk.press("Next");
  const Figure next = desk.figure();
  Settings fourth = settings_at(lesson, 3);
  fourth.size = next.settings.size, fourth.view = next.settings.view;
  EXPECT_EQ(next.settings, fourth);
  EXPECT_EQ(desk.close(), 0);
}

TEST(Window, both_lessons_are_given_from_the_keyboard) {
  const std::vector<std::string> ids = lesson_ids();
  for (const std::string& id : ids) {
    WindowDesk desk({"--lesson", id});
    SKIP_WITHOUT_WINDOW(desk);
    const Lesson lesson = load_lesson(id);
    for (size_t step = 0; step < lesson.steps.size(); ++step) {
      Figure now = desk.figure();
      Settings expected = settings_at(lesson, step);
      expected.size = now.settings.size;
      expected.view = now.settings.view;
      EXPECT_EQ(now.settings, expected) << id << " step " << step + 1;
      if (!lesson.steps[step].answer.empty()) {
        desk.press("Return");
        const Figure revealed = desk.figure();
        EXPECT_FALSE(revealed.picture == now.picture) << "the answer of step " << step + 1;
        now = revealed;
      }
      desk.keep(id + "-" + std::to_string(step + 1), now);
      desk.press("Next");
    }
  }
}

TEST(Window, camera_keys_move_while_held) {
  WindowDesk desk;
  SKIP_WITHOUT_WINDOW(desk);
  const Camera before = desk.figure().settings.camera;
  desk.hold("w", 400);
  const Camera after = desk.figure().settings.camera;
  EXPECT_GT(glm::dot(after.position - before.position, before.forward()), 1);
}

}  // namespace
}  // namespace gbl
