// Every row of the key table, pressed.
#include <cctype>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

#include "renderer/frame/validate.h"
#include "renderer/options/settings_json.h"
#include "tests/ui/ui_desk.h"

namespace gbl::ui {
namespace {

std::string lower(std::string_view key) {
  return {static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])))};
}

TEST(Keys, EveryOptionsKeyStepsItAndShiftStepsBack) {
  Desk desk;
  for (const Option& o : options()) {
    if (!*o.key || o.kind != Kind::choice) continue;
    const Settings before = desk.settings;
    Settings expected = before;
    cycle(o, expected, 1, {});
    desk.press(lower(o.key));
    EXPECT_EQ(desk.settings, expected) << o.path;
    desk.press(lower(o.key), true);
    EXPECT_EQ(desk.settings, before) << o.path << " backwards";
    for (const ValueRow& r : o.values)
      if (FeatureSet().has(r.needs)) desk.press(lower(o.key));  // the desk has no features: such rows are passed over
    EXPECT_EQ(desk.settings, before) << o.path << " all the way round";
  }
}

TEST(Keys, TheFirstPressOfCIsBack) {
  Desk desk;
  EXPECT_EQ(desk.settings.lights.cull, LightCull::flip);
  const LightCull order[] = {LightCull::back, LightCull::none, LightCull::front, LightCull::flip_safe, LightCull::flip};
  for (const LightCull cull : order) {
    desk.press("c");
    EXPECT_EQ(desk.settings.lights.cull, cull);
  }
}

TEST(Keys, BracketsWalkThePowersOfTwoToBothEnds) {
  Desk desk;
  for (const int n : {32, 16, 8, 4, 2, 1, 0, 0}) {
    desk.press("[");
    EXPECT_EQ(desk.settings.lights.count, n);
  }
  for (int n = 1; n <= kMaxLights; n *= 2) {
    desk.press("]");
    EXPECT_EQ(desk.settings.lights.count, n);
  }
  desk.press("]");
  EXPECT_EQ(desk.settings.lights.count, kMaxLights);
  desk.settings.lights.count = 100;
  desk.press("]");
  EXPECT_EQ(desk.settings.lights.count, 128);
  desk.settings.lights.count = 100;
  desk.press("[");
  EXPECT_EQ(desk.settings.lights.count, 64);
}

// Those that this device cannot draw are passed over.
TEST(Keys, BGoesRoundThePresetsAndKeepsTheSize) {
  Desk desk;
  std::vector<const Preset*> drawable;
  for (const Preset& p : presets())
    if (validate(p.make(), {desk.features}).empty()) drawable.push_back(&p);
  ASSERT_GE(drawable.size(), presets().size() - 2);
  desk.settings.size = {800, 450};
  for (size_t i = 1; i <= drawable.size(); ++i) {
    desk.press("b");
    const Preset* now = preset_of(desk.settings);
    ASSERT_TRUE(now);
    EXPECT_EQ(now, drawable[i % drawable.size()]);
    EXPECT_EQ(desk.settings.size, glm::ivec2(800, 450));
  }
  desk.press("b", true);
  EXPECT_EQ(preset_of(desk.settings), drawable.back());
}

TEST(Keys, AllViewsInTheMosaicAndOneAlone) {
  Desk desk;
  EXPECT_EQ(desk.visible(), 8);
  EXPECT_EQ(desk.requests.picture_size, glm::ivec2(800, 450));
  for (const ViewRow& v : views()) {
    if (!*v.key) continue;
    const std::string key(1, std::string_view(v.key).back());
    const bool shift = std::string_view(v.key).starts_with("Shift ");
    const bool there = why_missing(v.view, desk.settings).empty();
    desk.press(key, shift);
    EXPECT_EQ(desk.settings.view.main, v.id);
    EXPECT_EQ(desk.visible(), there) << v.id;
    EXPECT_EQ(desk.requests.visible[static_cast<size_t>(v.view)], there) << v.id;
    EXPECT_EQ(desk.requests.picture_size, glm::ivec2(1200, 675));
    desk.press("0");
    EXPECT_EQ(desk.visible(), 8);
    desk.press(key, shift);
    desk.press(key, shift);
    EXPECT_EQ(desk.visible(), 8) << "the same key again";
  }
}

TEST(Keys, HomeIsTheStateAsLoaded) {
  Settings loaded = preset("nclgl-fixed").make();
  loaded.lights.count = 5;
  Desk desk({1600, 900}, false, loaded);
  for (const char* key : {"c", "n", "]", "b", "l", "7", "space", "."}) desk.press(key);
  desk.held = {"w"};
  desk.seconds += 0.1;
  desk.frame();
  desk.held.clear();
  EXPECT_NE(desk.settings, loaded);
  desk.press("Home");
  EXPECT_EQ(desk.settings, loaded);
  EXPECT_EQ(desk.visible(), 7);  // nclgl stores no roughness
}

TEST(Keys, NoKeyOfTheTableMakesSettingsInvalidOrTextsOverflow) {
  for (const KeyRow& row : key_rows()) {
    for (const KeyEvent& once : presses_of(row)) {
      for (const bool shift : {once.shift, true}) {
        Desk desk;
        KeyEvent e = once;
        e.shift = shift;
        for (int i = 0; i < 3; ++i) {
          desk.frame({e});
          EXPECT_TRUE(validate(desk.settings, {}).empty()) << row.id;
          EXPECT_TRUE(desk.ui.cut_texts().empty()) << row.id << ": " << desk.ui.cut_texts().front();
        }
      }
    }
  }
}

TEST(Keys, EachKeyIsInOneRowAndEachRowHasAHelp) {
  std::set<std::string> seen, ids;
  for (const KeyRow& row : key_rows()) {
    EXPECT_FALSE(row.help.empty()) << row.id;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    for (const KeyEvent& e : presses_of(row))
      EXPECT_TRUE(seen.insert(fmt::format("{}{}{}", e.ctrl, e.shift, e.key)).second) << e.key << " of " << row.id;
  }
}

TEST(Keys, ARequestLastsOneFrame) {
  Desk desk;
  EXPECT_TRUE(desk.press("F5").reload_shaders);
  desk.settings.view.main = "depth";  // a small panel of the mosaic
  const Requests figure = desk.press("F12");
  ASSERT_TRUE(figure.figure);
  EXPECT_EQ(figure.figure->size.x, 400) << "the chosen panel";
  EXPECT_NE(figure.figure->caption[0].find("depth"), std::string::npos);
  EXPECT_FALSE(desk.frame().figure);
}

// The scene's own lights are as many as the scene has, whatever lights.count says of generated ones.
TEST(Keys, PickAndSoloKnowTheLightsOfTheScene) {
  Desk desk;
  desk.scene.lights.resize(4);
  for (Light& l : desk.scene.lights) l.range = 100;
  desk.settings.lights.source = LightSource::scene;
  desk.settings.view.pick = 3;
  desk.press(".");
  EXPECT_EQ(desk.settings.view.pick, 0);
  desk.press(",");
  EXPECT_EQ(desk.settings.view.pick, 3);
  desk.press(".", true);
  EXPECT_EQ(desk.settings.lights.only, 3);
  EXPECT_EQ(lights_of(desk.settings, desk.scene).size(), 1u);
  desk.press("]");  // goes on from four, and the light that was alone is one of the eight
  EXPECT_EQ(desk.settings.lights.source, LightSource::generated);
  EXPECT_EQ(desk.settings.lights.count, 8);
  desk.settings.lights.source = LightSource::scene;
  desk.press("[");
  EXPECT_EQ(desk.settings.lights.count, 2);
  EXPECT_EQ(desk.settings.lights.only, -1) << "light 3 is gone";
}

TEST(Keys, SoloFollowsThePickAndEndsWithItsLight) {
  Desk desk;
  desk.settings.view.pick = 63;
  desk.press(".");
  EXPECT_EQ(desk.settings.view.pick, 0);
  desk.press(",");
  EXPECT_EQ(desk.settings.view.pick, 63);
  desk.press(",", true);
  EXPECT_EQ(desk.settings.lights.only, 63);
  desk.press(",");
  EXPECT_EQ(desk.settings.lights.only, 62);
  desk.press("[");  // 32 lights: there is no light 62
  EXPECT_EQ(desk.settings.lights.only, -1);
  desk.press(",");
  desk.press(".", true);
  desk.press(".", true);
  EXPECT_EQ(desk.settings.lights.only, -1);
}

TEST(Keys, AnOptionIsReachedByItsKeyOrByALetterOfItsPage) {
  Desk desk;
  std::set<std::string> reached;
  for (int page = 0; page < option_pages(); ++page) {
    desk.press("o");
    const std::vector<const Option*> all = options_on_page(page);
    for (const Option* o : all) {
      reached.insert(o->path);
      if (*o->key) continue;
      const std::string letter = option_letter(all, *o);
      ASSERT_EQ(letter.size(), 1u) << o->path;
      if (o->kind != Kind::choice) continue;
      const Settings before = desk.settings;
      Settings expected = before;
      do cycle(*o, expected, 1, {});  // rows that make no sense as things stand are passed over
      while (!validate(expected, {}).empty());
      desk.press(lower(letter));
      EXPECT_EQ(desk.settings, expected) << o->path;
      expected = before;
      desk.press(lower(letter), true);
      EXPECT_EQ(desk.settings, expected) << o->path;
    }
  }
  EXPECT_EQ(reached.size(), options().size());
}

TEST(Keys, ArrowsNudgeTheHeldPixelAndCtrlGGoesToOne) {
  Desk desk;
  desk.press("g", false, true);
  desk.frame();
  desk.type("7, 360");
  ASSERT_TRUE(desk.requests.probe);
  EXPECT_EQ(*desk.requests.probe, glm::ivec2(7, desk.settings.size.y / 2));
  desk.press("Left");
  EXPECT_EQ(desk.requests.probe->x, 6);
  desk.press("Left", true);
  EXPECT_EQ(desk.requests.probe->x, 0);
  desk.press("Up", true);
  EXPECT_EQ(desk.requests.probe->y, desk.settings.size.y / 2 - 10);
  desk.press("Esc");
  EXPECT_FALSE(desk.requests.probe);
}

// What a click into F1's list left behind, wherever it went.
std::set<std::string> left_by_clicks(Desk& desk) {
  const Settings loaded = desk.settings;
  std::set<std::string> left;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const int across = static_cast<int>(display.x), down = static_cast<int>(display.y);
  for (int x = 34; x < across; x += (across - 48) / 3)  // the first key of each column's rows
    for (int y = 60; y < down - 40; y += 9) {
      desk.settings = loaded;
      desk.press("F1");
      if (!desk.ui.is_open("help")) desk.press("F1");
      desk.click({static_cast<float>(x), static_cast<float>(y)});
      if (!desk.ui.is_open("help")) left.insert(settings_text(desk.settings));
      for (int i = 0; i < 4; ++i) desk.press("Esc");
    }
  return left;
}

TEST(Keys, EachOptionCanBeChosenInTheListByAClick) {
  Desk desk;
  const Settings loaded = desk.settings;
  const std::set<std::string> left = left_by_clicks(desk);
  for (const Option& o : options()) {
    if (!*o.key || o.kind != Kind::choice) continue;
    desk.settings = loaded;
    desk.frame({presses_of({o.key, o.path, ""}).front()});
    EXPECT_TRUE(left.count(settings_text(desk.settings))) << o.path;
  }
}

TEST(Keys, PanelKeysAreOnOnlyBetweenF6AndEsc) {
  Desk desk;
  const auto on = [] { return (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0; };
  EXPECT_FALSE(on());
  desk.press("F6");
  EXPECT_TRUE(on());
  desk.press("Space");
  EXPECT_FALSE(desk.ui.moving(desk.settings));
  desk.press("Esc");
  EXPECT_FALSE(on());
}

}  // namespace
}  // namespace gbl::ui
