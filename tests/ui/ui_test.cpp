// What stands on the screen: texts that fit, glyphs that exist, the mouse, motion, captions, sheets.
#include <gtest/gtest.h>
#include <imgui.h>
#include <set>

#include "renderer/frame/frame_lights.h"
#include "renderer/lessons/lessons.h"
#include "tests/ui/ui_desk.h"
#include "ui/camera_motion.h"
#include "ui/sheet.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

TEST(Window, NoTextIsCutAtAnySizeOrScale) {
  const char* screens[] = {"0", "1", "F1", "o", "h", "b", "n", "PgDn"};
  for (const ImVec2 display : {ImVec2{1600, 900}, {1280, 720}, {1920, 1080}, {1366, 768}, {1600, 1200}, {2560, 1080}})
    for (const bool present : {false, true}) {
      for (const char* screen : screens) {
        Desk desk(display, present);
        desk.press(screen);
        EXPECT_TRUE(desk.ui.cut_texts().empty()) << display.x << "x" << display.y << (present ? " presenting " : " ")
                                                 << screen << ": " << desk.ui.cut_texts().front();
      }
    }
}

TEST(Window, EveryCardFits) {
  for (const bool present : {false, true})
    for (const bool large : {false, true}) {
      Desk desk({1280, 720}, present);
      for (const ViewRow& v : views()) {
        if (!*v.key) continue;
        desk.press("0");
        desk.press(v.key);
        if (!large) desk.press("0");
        desk.press("h");
        EXPECT_TRUE(desk.ui.cut_texts().empty()) << v.id << ": " << desk.ui.cut_texts().front();
        desk.press("h");
      }
    }
}

// The glyphs of every text that the tables can put on screen are in the font.
TEST(Window, NoTextOfTheTablesLacksAGlyph) {
  Desk desk;
  std::string all;
  for (const Option& o : options()) {
    all += std::string(o.label) + o.help + o.unit;
    for (const ValueRow& r : o.values) all += std::string(r.label) + r.help + r.cost + r.source;
  }
  for (const ViewRow& v : views())
    all += std::string(v.label) + v.sentence + v.space + v.unit + v.range + v.read_by + v.decode + v.in_sources +
           v.mistake;
  for (const KeyRow& k : key_rows()) all += k.key + k.help;
  for (const Preset& p : presets()) all += std::string(p.label) + p.help;
  for (const std::string& id : lesson_ids()) {
    const Lesson lesson = load_lesson(id);
    all += lesson.title;
    for (const LessonStep& s : lesson.steps) all += s.say + s.question + s.answer;
  }
  const ImFont* font = ImGui::GetIO().Fonts->Fonts[0];
  for (size_t i = 0; i < all.size();) {
    const auto byte = static_cast<unsigned char>(all[i]);
    const int length = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
    unsigned code = byte & (length == 1 ? 0x7F : 0xFF >> (length + 1));
    for (int k = 1; k < length; ++k)
      code = code << 6 | (static_cast<unsigned char>(all[i + static_cast<size_t>(k)]) & 0x3F);
    EXPECT_TRUE(length < 4 && font->FindGlyphNoFallback(static_cast<ImWchar>(code))) << all.substr(i, 20);
    i += static_cast<size_t>(length);
  }
}

TEST(Window, WhatIsBelowAnOverlayIsNotDrawn) {
  Desk desk;
  desk.press("F1");
  EXPECT_EQ(desk.visible(), 0);
  desk.press("Esc");
  desk.press("o");
  EXPECT_EQ(desk.visible(), 6);  // the two pictures at the right edge
  desk.press("Esc");
  desk.press("h");
  EXPECT_EQ(desk.visible(), 4);  // the card of `final` stands on the four beside it
  desk.press("h");
  EXPECT_EQ(desk.visible(), 8);
}

TEST(Window, AViewThatIsNotStoredKeepsItsKeyAndIsNotDrawn) {
  Desk desk;
  desk.settings.accumulation.targets = AccumulationTargets::one;
  desk.press("6");
  EXPECT_EQ(desk.settings.view.main, "diffuse-light");
  EXPECT_EQ(desk.visible(), 0);
  desk.press("0");
  EXPECT_EQ(desk.visible(), 6);
}

TEST(Window, TheGlideEndsInsideTheLightAndGoesBack) {
  Desk desk;
  const Camera before = desk.settings.camera;
  desk.press("i");
  EXPECT_TRUE(desk.ui.moving(desk.settings));
  desk.seconds += 0.6;
  desk.frame();
  EXPECT_NE(desk.settings.camera, before);
  desk.seconds += 0.7;
  desk.frame();
  EXPECT_FALSE(desk.ui.moving(desk.settings));
  const Light light = lights_of(desk.settings, desk.scene)[static_cast<size_t>(desk.settings.view.pick)];
  EXPECT_NEAR(glm::length(desk.settings.camera.position - light.position), light.range / 2, 1e-6);
  desk.press("i");
  desk.seconds += 2;
  desk.frame();
  EXPECT_EQ(desk.settings.camera, before);
}

TEST(Window, TheCameraMovesWhileAKeyIsHeldAndOnlyThen) {
  Desk desk;
  const glm::dvec3 from = desk.settings.camera.position, ahead = desk.settings.camera.forward();
  desk.held = {"w"};
  desk.seconds += 0.1;
  desk.frame();
  const glm::dvec3 step = desk.settings.camera.position - from;
  EXPECT_GT(glm::dot(step, ahead), 0);
  EXPECT_NEAR(glm::length(step), glm::dot(step, ahead), 1e-6);
  desk.held = {"s", "Shift"};
  desk.seconds += 0.1;
  desk.frame();
  EXPECT_NEAR(glm::length(desk.settings.camera.position - from), 3 * glm::length(step), 1e-6);
  desk.held.clear();
  const Settings rest = desk.settings;
  desk.seconds += 5;
  desk.frame();
  EXPECT_EQ(desk.settings, rest);
}

TEST(Window, ATextThatCannotFitIsNoted) {
  Desk desk;
  ImGui::NewFrame();
  std::vector<std::string> cut;
  Painter p(*ImGui::GetBackgroundDrawList(), cut);
  p.fit("fits", {100, 20}, 15, false);
  EXPECT_TRUE(cut.empty());
  p.fit("does not", {5, 20}, 15, false);
  EXPECT_EQ(cut, std::vector<std::string>{"does not"});
  ImGui::EndFrame();
}

TEST(Window, AMethodWhoseFeatureIsMissingIsPassedOver) {
  Desk desk;
  for (const bool compute : {false, true}) {
    if (compute) desk.features.add(Feature::compute);
    std::set<LightMethod> seen;
    for (size_t k = 0; k < 2 * rows<LightMethod>().size(); ++k) {
      desk.press("m");
      seen.insert(desk.settings.lights.method);
    }
    EXPECT_EQ(seen.count(LightMethod::tiled), compute);
    EXPECT_EQ(seen.count(LightMethod::clustered), 1u);
    EXPECT_EQ(seen.count(LightMethod::auto_), 1u);
  }
}

TEST(Window, SpaceLetsTimeRun) {
  Desk desk;
  desk.press("Space");
  desk.seconds += 0.2;
  desk.frame();
  EXPECT_NEAR(desk.settings.time_s, 0.2, 1e-12);
  desk.press("Space");
  desk.seconds += 0.2;
  desk.frame();
  EXPECT_NEAR(desk.settings.time_s, 0.2, 1e-12);
}

TEST(Window, ANumberIsTypedAndABadOneIsRefused) {
  Desk desk;
  const auto holds_pick = [](const std::vector<const Option*>& page) {
    return std::find(page.begin(), page.end(), &option("view.pick")) != page.end();
  };
  int number = 0;
  while (!holds_pick(options_on_page(number))) ++number;
  const std::vector<const Option*> page = options_on_page(number);
  for (int k = 0; k <= number; ++k) desk.press("o");
  const std::string letter = option_letter(page, option("view.pick"));
  desk.press(letter);
  desk.frame();
  desk.press("c");  // the field has the keyboard
  EXPECT_EQ(desk.settings.lights.cull, LightCull::flip);
  desk.type("12");
  EXPECT_EQ(desk.settings.view.pick, 12);
  desk.press(letter);
  desk.frame();
  desk.type("99999999");
  EXPECT_EQ(desk.settings.view.pick, 12);
  desk.press("Esc");
  desk.press("c");
  EXPECT_EQ(desk.settings.lights.cull, LightCull::back);
}

TEST(Mouse, HoverReadsThePixelWithItsOriginTopLeft) {
  Desk desk;
  EXPECT_FALSE(desk.requests.probe);
  desk.point({0.5f, 0.5f});
  EXPECT_EQ(desk.requests.probe, glm::ivec2(0, 0));
  desk.point({800 + 399.5f, 224.5f});  // albedo's last corner: the same frame at half the size
  EXPECT_EQ(desk.requests.probe, glm::ivec2(1278, 718));
  desk.point({1300, 800});
  EXPECT_FALSE(desk.requests.probe);
}

TEST(Mouse, AClickHoldsThePixelAndChoosesTheView) {
  Desk desk;
  desk.click({100, 100});
  desk.point({1300, 800});
  EXPECT_EQ(desk.requests.probe, glm::ivec2(160, 160));
  desk.report.size = {640, 360};  // drawn at half the size: the same place
  desk.frame();
  EXPECT_EQ(desk.requests.probe, glm::ivec2(80, 80));
  desk.report.size = {1280, 720};
  desk.click({1300, 100});
  EXPECT_EQ(desk.settings.view.main, "normal");
  EXPECT_EQ(desk.visible(), 8);
  EXPECT_EQ(desk.requests.probe, glm::ivec2(321, 321));
  for (int k = 0; k < 60; ++k) desk.frame();  // longer than a double click takes
  desk.click({1300, 100});
  desk.point({1300, 800});
  EXPECT_FALSE(desk.requests.probe) << "the same pixel again lets go";
  desk.click({100, 100});
  EXPECT_TRUE(desk.requests.probe);
  desk.point({100, 100}, false, true);
  desk.point({1300, 800});
  EXPECT_FALSE(desk.requests.probe) << "so does a right click";
}

TEST(Mouse, ADoubleClickEnlargesAndHoldsNothing) {
  Desk desk;
  desk.click({1300, 100});
  desk.click({1300, 100});
  EXPECT_EQ(desk.settings.view.main, "normal");
  EXPECT_EQ(desk.visible(), 1);
  desk.point({1300, 800});
  EXPECT_FALSE(desk.requests.probe);
}

TEST(Mouse, TheWheelZoomsWhereTheMouseIsInAllPanels) {
  Desk desk;
  const auto wheel = [&](ImVec2 at, float notches, bool shift = false) {
    desk.point(at);
    ImGui::GetIO().KeyShift = shift;
    ImGui::GetIO().MouseWheel = notches;
    desk.frame();
    ImGui::GetIO().MouseWheel = 0, ImGui::GetIO().KeyShift = false;
    desk.frame();
  };
  const ImVec2 at{300, 200};
  desk.point(at);
  const glm::ivec2 pixel = desk.requests.probe.value();
  wheel(at, 5);
  EXPECT_NEAR(desk.settings.view.zoom, std::pow(1.25, 5), 1e-9);
  EXPECT_EQ(desk.requests.probe, pixel) << "what is below the mouse stays there";
  EXPECT_TRUE(desk.requests.magnified);
  desk.point({800 + 150, 100});  // albedo, at half the size: the same place of the picture
  EXPECT_LE(glm::length(glm::vec2(desk.requests.probe.value() - pixel)), 2);
  const double linked = desk.settings.view.zoom;
  wheel({1300, 100}, 3, true);
  EXPECT_EQ(desk.settings.view.zoom, linked) << "with Shift this panel alone";
  wheel(at, 100);
  EXPECT_LE(desk.settings.view.zoom, 1280 * 128 / 800.0) << "a pixel is no larger than its numbers need";
  ASSERT_TRUE(desk.requests.numbers);
  EXPECT_EQ(desk.requests.numbers->first, View::final);
  const PixelGrid& grid = desk.requests.numbers->second;
  EXPECT_LE(grid.pixels(), 60u) << "only those that are seen";
  EXPECT_TRUE(glm::all(glm::lessThanEqual(grid.first, pixel)) &&
              glm::all(glm::lessThan(pixel, grid.first + grid.count)));
  wheel(at, -100);
  EXPECT_EQ(desk.settings.view.zoom, 1);
  EXPECT_FALSE(desk.requests.numbers);
  desk.press("f", false, true);
  EXPECT_FALSE(desk.requests.magnified) << "Ctrl+F: the whole picture in all panels";
}

TEST(Mouse, ADragMovesAZoomedPictureAndLeavesTheCamera) {
  Desk desk;
  desk.settings.view.zoom = 4;
  const Camera before = desk.settings.camera;
  desk.point({400, 200});
  desk.point({400, 200}, true);
  desk.point({320, 200}, true);
  desk.point({320, 200});
  EXPECT_EQ(desk.settings.camera, before);
  EXPECT_NEAR(desk.settings.view.centre.x, 0.5 + 80.0 / 800 / 4, 1e-6);
  EXPECT_EQ(desk.settings.view.centre.y, 0.5);
}

TEST(Looks, KeysChangeTheLargeView) {
  Desk desk;
  desk.press("3");
  const auto look = [&] { return look_of(desk.settings.view.looks, "normal"); };
  desk.press("l", false, true);
  EXPECT_EQ(look().channels, "r");
  desk.press("m", false, true);
  EXPECT_EQ(look().map, ColourMap::grey);
  desk.press("r", false, true);
  EXPECT_TRUE(look().fit);
  EXPECT_EQ(desk.settings.view.looks.size(), 1u);
  desk.press("Home");
  EXPECT_TRUE(desk.settings.view.looks.empty());
}

// From the picture to why a pixel is wrong, with the mouse alone: error, a pixel of it, why.
TEST(Looks, ErrorAndWhyAreButtons) {
  Desk desk;
  const auto press_until = [&](auto done) {
    const float right = static_cast<float>(desk.requests.picture_size.x);
    for (float x = right - 6; x > right / 4 && !done(); x -= 6) desk.click({x, 12});
    return done();
  };
  EXPECT_TRUE(press_until([&] { return desk.settings.view.main == "error"; }));
  desk.click({300, 300});
  EXPECT_TRUE(desk.requests.probe);
  EXPECT_TRUE(press_until([&] { return desk.ui.is_open("pixel"); }));
  desk.frame();
  EXPECT_TRUE(desk.requests.account);
}

// The buttons at the right end of the picture's upper edge, from the right: fit, 1:1, histogram, range, map, B, G, R.
TEST(Looks, ButtonsStandAboveThePictureAndDoNotHoldPixels) {
  Desk desk;
  desk.press("2");
  int changes = 0;
  bool looked = false;
  Settings before = desk.settings;
  for (int x = 1190; x > 900; x -= 6) {
    desk.click({static_cast<float>(x), 12});
    desk.point({1300, 800});
    if (!(desk.settings == before)) ++changes;
    before = desk.settings;
    looked |= !before.view.looks.empty();
    if (desk.requests.probe) break;  // left of the last button
  }
  EXPECT_GE(changes, 6);
  EXPECT_TRUE(looked);
}

TEST(Mouse, ADragOnTheLargePictureLooksAroundAndChoosesNothing) {
  Desk desk;
  desk.settings.view.main = "depth";
  const Camera before = desk.settings.camera;
  desk.point({100, 100});
  desk.point({100, 100}, true);
  desk.point({140, 90}, true);
  desk.point({140, 90});
  EXPECT_EQ(desk.settings.camera.position, before.position);
  const glm::dvec2 turn = yaw_pitch_of(desk.settings.camera.orientation) - yaw_pitch_of(before.orientation);
  EXPECT_NEAR(turn.x, -4, 1e-6);  // 45 degrees are 450 pixels high
  EXPECT_NEAR(turn.y, 1, 1e-6);
  EXPECT_EQ(desk.settings.view.main, "depth");
}

TEST(History, UndoAndRedoWalkThroughTheSettings) {
  Desk desk;
  const Settings first = desk.settings;
  desk.press("c");
  desk.frame();
  const Settings second = desk.settings;
  desk.press("n");
  desk.frame();
  const Settings third = desk.settings;
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings, second);
  desk.frame();
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings, first);
  desk.frame();
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings, first) << "nothing is left to take back";
  desk.press("y", false, true);
  desk.frame();
  desk.press("y", false, true);
  EXPECT_EQ(desk.settings, third);
  desk.frame();
  desk.press("z", false, true);
  desk.frame();
  desk.press("t");
  desk.frame();
  const Settings other = desk.settings;
  desk.press("y", false, true);
  EXPECT_EQ(desk.settings, other) << "what was taken back is gone after another change";
}

TEST(History, ADragIsOneStep) {
  Desk desk;
  desk.frame();
  const Camera before = desk.settings.camera;
  desk.point({100, 100});
  desk.point({100, 100}, true);
  for (int x = 110; x < 200; x += 10) desk.point({static_cast<float>(x), 90}, true);
  desk.point({190, 90});
  desk.frame(), desk.frame();
  ASSERT_FALSE(desk.settings.camera == before);
  desk.press("z", false, true);
  EXPECT_EQ(desk.settings.camera, before);
}

TEST(Glides, AreJumpsWhereLessMotionIsWanted) {
  Desk desk;
  desk.still = true;
  const Camera before = desk.settings.camera;
  desk.press("i");
  EXPECT_FALSE(desk.settings.camera == before);
  EXPECT_FALSE(desk.ui.moving(desk.settings));
}

// The buttons of the large view give way to its name: a click on the name is none of theirs.
TEST(ViewTools, LeaveTheNameFreeInAWindowOfAnyWidth) {
  for (const float width : {1600.0f, 900.0f, 700.0f, 520.0f, 420.0f}) {
    Desk desk({width, 0.6f * width});
    desk.press("3");
    const Box name = badge_box({{0, 0}, {width, width}}, View::normal, desk.settings, kSmallestPx);
    constexpr int kPlaces = 16;
    for (int k = 1; k < kPlaces; ++k) {
      const float x = name.min.x + name.width() * static_cast<float>(k) / kPlaces;
      const Settings before = desk.settings;
      desk.click({x, name.min.y + 6});
      EXPECT_EQ(desk.settings, before) << width << " wide, at " << x;
      EXPECT_FALSE(desk.ui.is_open("pixel")) << width << " wide, at " << x;
      desk.seconds += 1;
    }
  }
}

TEST(InWords, SayTheViewThePixelTheStepAndWhatIsWrong) {
  Desk desk;
  desk.press("3");
  const ViewRow& normal = view_by_id("normal");
  EXPECT_NE(desk.requests.in_words.find(std::string(normal.label) + ": " + normal.sentence), std::string::npos);
  EXPECT_EQ(desk.requests.in_words.find("\npixel "), std::string::npos) << "nobody points at one";
  desk.ui.open_lesson("ten-minutes", desk.settings);
  desk.message = "what is wrong";
  desk.press("g", false, true);
  desk.frame();
  desk.type("7, 5");
  const std::string words = desk.requests.in_words;
  EXPECT_NE(words.find("\npixel 123, 456 "), std::string::npos) << words;  // as the desk probes it
  EXPECT_NE(words.find(load_lesson("ten-minutes").steps[0].say), std::string::npos);
  EXPECT_NE(words.find("what is wrong"), std::string::npos);
}

TEST(Lessons, TellTheirPlaceAndOpenThere) {
  Desk desk;
  EXPECT_EQ(desk.ui.lesson_place(), "");
  desk.ui.open_lesson("ten-minutes:3", desk.settings);
  desk.frame();
  const Settings third = desk.settings;
  EXPECT_EQ(desk.ui.lesson_place(), "ten-minutes:3");
  desk.press("PgUp"), desk.press("PgUp");
  EXPECT_EQ(desk.ui.lesson_place(), "ten-minutes:1");
  EXPECT_NE(desk.settings, third);
  desk.press("PgDn"), desk.press("PgDn");
  EXPECT_EQ(desk.ui.lesson_place(), "ten-minutes:3");
  EXPECT_EQ(desk.settings, third);
}

TEST(Pages, EveryViewThatIsStoredHasAPlaceOnOne) {
  for (const Preset& p : presets()) {
    Desk desk({1600, 900}, false, p.make());
    std::array<bool, kViewCount> seen{};
    for (size_t page = 0; page < 4; ++page) {
      for (size_t v = 0; v < seen.size(); ++v) seen[v] |= desk.requests.visible[v];
      desk.press("0");
    }
    for (const ViewRow& v : views()) {
      if (needs_truth(v.view)) continue;
      EXPECT_EQ(seen[static_cast<size_t>(v.view)], why_missing(v.view, desk.settings).empty()) << p.id << " " << v.id;
    }
  }
}

TEST(Sheets, AreAsLargeAsTheirTilesAndGrowWithCaptions) {
  Desk desk;
  Sheet sheet{.title = "Title", .columns = 2, .tile_width = 480};
  for (const View v : {View::final, View::depth}) sheet.tiles.push_back(SheetTile{v, {}, desk.settings, {}, {}});
  const glm::ivec2 bare = sheet_size(sheet);
  EXPECT_EQ(bare.x, 2 * 480 + 12 + 2 * 16);
  sheet.tiles[1].caption = "a caption below the picture";
  EXPECT_GT(sheet_size(sheet).y, bare.y);
}

}  // namespace
}  // namespace gbl::ui
