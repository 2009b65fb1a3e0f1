// Settings out of files and pictures, and what a file is taken for.
#include "app/file_opening.h"

#include <fstream>

#include "app/commands.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

const Image kDot{{1, 1}, {1, 2, 3, 255}};

class Files : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  std::string picture(const std::string& name, const PngText& texts) {
    write_png(folder_ / name, kDot, texts);
    return (folder_ / name).string();
  }
  TemporaryFolder folder_{"files"};
};

class StateFiles : public Files {};

TEST_F(StateFiles, APictureGivesItsSettingsWhateverItIsCalled) {
  const Settings s = preset("nclgl").make();
  for (const char* name : {"a.png", "b.PNG", "no-ending"})
    EXPECT_EQ(read_state(picture(name, {{kSettingsKey, settings_text(s)}})), s) << name;
  EXPECT_EQ(read_state(put("s.json", settings_text(s))), s);
  const std::string file = picture("a.png", {{kSettingsKey, settings_text(s)}});
  const char* const words[] = {"gbufferlab", "render", "--state", file.c_str()};
  EXPECT_EQ(setup_of(parse_arguments(4, words).value()).settings, s);
}

TEST_F(StateFiles, WhatIsWrongWithAPictureIsSaid) {
  const auto refused = [](const std::string& file) {
    std::string line = error_line(ExitCode::bad_input, [&] { read_state(file); });
    EXPECT_PRED2(contains, line, file);
    return line;
  };
  EXPECT_PRED2(contains, refused(picture("a.png", {})), "is a PNG without settings in it");
  EXPECT_PRED2(contains, refused(picture("b.png", {{kSettingsKey, "{\"version\": 99}"}})), "newer program: version 99");
  EXPECT_PRED2(contains, refused(picture("c.png", {{kSettingsKey, "{\"versi"}})), "not valid JSON");
  EXPECT_PRED2(contains, refused(put("d.png", "{\"version\": 1}")), "is not a PNG");
  EXPECT_PRED2(contains, refused((folder_ / "missing.png").string()), "is not a PNG that can be read");
  EXPECT_PRED2(contains, refused((folder_ / "missing.json").string()), "cannot be read");
}

class FileOpenings : public Files {};

TEST_F(FileOpenings, EachKindIsTakenForWhatItIs) {
  EXPECT_EQ(opening_of(put("m.glb", "x"), {}).scene, folder_ / "m.glb");
  EXPECT_EQ(opening_of(put("m.GLTF", "x"), {}).scene, folder_ / "m.GLTF");
  EXPECT_FALSE(opening_of(put("m.glb", "x"), {}).whole);
  Settings s = preset("start").make();
  s.scene = "builtin:room";
  const FileOpening state = opening_of(put("s.json", settings_text(s)), {});
  EXPECT_TRUE(state.whole);
  EXPECT_EQ(state.scene, "builtin:room");
  const FileOpening rig = opening_of(put("r.json", R"({"version": 1, "lights": []})"), {});
  EXPECT_EQ(rig.scene, "");
  EXPECT_EQ(rig.settings(s, Scene{}).lights.rig, folder_ / "r.json");
}

// A state that somebody sends beside a file of GLSL must not have it run.
TEST_F(FileOpenings, ShaderTextIsNotRunUnasked) {
  const std::string mine = put("mine.glsl", "// attachments: material RG8 { r: metal; g: roughness }\n");
  Settings s = preset("start").make();
  apply_assignment(s, "layout-file=" + mine);
  const FileOpening state = opening_of(put("s.json", settings_text(s)), {});
  EXPECT_EQ(state.settings(preset("start").make(), Scene{}).layout_file, "");
  EXPECT_PRED2(contains, state.said, "--layout-file " + mine);
  EXPECT_EQ(state.settings(s, Scene{}).layout_file, s.layout_file) << "it runs already";
}

TEST_F(FileOpenings, AnythingElseIsRefused) {
  const auto refused = [](const std::string& file) {
    return error_line(ExitCode::bad_input, [&] { opening_of(file, {}); });
  };
  EXPECT_PRED2(contains, refused(put("a.obj", "v 0 0 0")), "give a model (.gltf, .glb), settings or a rig");
  EXPECT_PRED2(contains, refused((folder_ / "none.glb").string()), "cannot be read: No such file");
  EXPECT_PRED2(contains, refused(folder_.path().string()), "is a folder");
  EXPECT_PRED2(contains, refused("/dev/null"), "is no file");
  EXPECT_PRED2(contains, refused(put("j.json", "[1")), "j.json:1:3: not valid JSON");
  EXPECT_PRED2(contains, refused(put("l.json", "{\"title\": \"a lesson\"}")), "not a settings file");
  EXPECT_PRED2(contains, refused(put("r.json", R"({"version": 1, "lights": [{"kind": "pont"}]})")), "point");
}

TEST_F(FileOpenings, SettingsThatCannotBeDrawnAreRefused) {
  Settings s = preset("start").make();
  s.lights.rig = "/gone/rig.json";
  s.lights.source = LightSource::rig;
  const std::string gone = put("rig-gone.json", settings_text(s));
  EXPECT_PRED2(contains, error_line(ExitCode::bad_input, [&] { opening_of(gone, {}); }), "/gone/rig.json");
  s = preset("start").make();
  s.size = {4096, 4096};
  const std::string large = put("large.json", settings_text(s));
  EXPECT_PRED2(contains, error_line(ExitCode::bad_input, [&] { opening_of(large, {.max_size = 2048}); }), "2048");
}

}  // namespace
}  // namespace gbl
