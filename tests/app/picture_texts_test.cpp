// A picture's texts: the command line that draws it again gives the settings that drew it.
#include "app/picture_texts.h"

#include <cstdio>

#include "renderer/base/made_by.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

// The words that a shell makes of a line.
std::vector<std::string> words_of(const std::string& line) {
  std::FILE* pipe = popen(("printf '%s\\n' " + line).c_str(), "r");
  std::vector<std::string> words(1);
  for (int c; (c = std::fgetc(pipe)) != EOF;) {
    if (c == '\n')
      words.emplace_back();
    else
      words.back().push_back(static_cast<char>(c));
  }
  pclose(pipe);
  words.pop_back();
  return words;
}

Settings drawn_by(const std::string& line) {
  const std::vector<std::string> words = words_of(line);
  std::vector<const char*> argv;
  for (const std::string& w : words) argv.push_back(w.c_str());
  return setup_of(parse_arguments(static_cast<int>(argv.size()), argv.data()).value()).settings;
}

TEST(PictureTexts, TheCommandLineGivesTheSettingsOfEveryPreset) {
  for (const Preset& p : presets()) {
    const Settings s = p.make();
    EXPECT_EQ(drawn_by(command_line("gbufferlab render --only final", s)), s) << command_line("", s);
  }
  EXPECT_EQ(command_line("gbufferlab render", preset("start").make()), "gbufferlab render");
}

TEST(PictureTexts, TheCommandLineGivesEveryValueOfEveryChoice) {
  for (const Option& o : options())
    for (const ValueRow& r : o.values) {
      Settings s = preset("start").make();
      o.set(s, r.id, o);
      EXPECT_EQ(drawn_by(command_line("gbufferlab render", s)), s) << o.path << "=" << r.id;
    }
}

TEST(PictureTexts, TextsNumbersAndListsAreWrittenForTheShell) {
  Settings s = preset("start").make();
  s.scene = "it's a/\"model\" $(of) ü.glb";
  s.lights.rig = "7";  // not a number
  s.camera.position = {0.1, -1e-9, 12345.678901234567};
  s.camera.orientation = orientation_from_yaw_pitch(123.456, -7.89);
  s.mistakes = {Mistake::tbn_precedence};
  s.view.main = "normal";
  set_look(s.view.looks, "depth", {.range = glm::dvec2(400.5, 600)});
  s.view.pick = 3;
  s.size = {64, 36};
  EXPECT_EQ(drawn_by(command_line("gbufferlab view", s)), s) << command_line("gbufferlab view", s);
}

TEST(PictureTexts, NameWhatDrewThePicture) {
  const TemporaryFolder folder("texts");
  Settings s = preset("start").make();
  s.lights.rig = "/rigs/ü.json";
  write_png(folder / "a.png", {{1, 1}, {1, 2, 3, 255}},
            picture_texts("gbufferlab render", s, {"3.3 Mesa", "llvmpipe"}));
  EXPECT_EQ(parse_settings(read_png_text(folder / "a.png", kSettingsKey), "picture"), s);
  EXPECT_EQ(read_png_text(folder / "a.png", kVersionKey), made_by());
  EXPECT_EQ(read_png_text(folder / "a.png", kDriverKey), "llvmpipe, OpenGL 3.3 Mesa");
  EXPECT_EQ(read_png_text(folder / "a.png", kCommandKey), "gbufferlab render --set 'lights.rig=/rigs/ü.json'");
}

}  // namespace
}  // namespace gbl
