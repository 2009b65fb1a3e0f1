// A file dropped on the window, through the functions that the window calls.
#include <filesystem>
#include <fstream>

#include "app/viewer.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/image.h"
#include "tests/gl_fixture.h"
#include "tests/gltf/gltf_fixture.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

class Drop : public test::GlTest {};

std::string written(const std::string& name, const std::string& bytes) {
  const fs::path path = fs::temp_directory_path() / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

TEST_F(Drop, AModelIsReadBesideThePictureAndBringsItsCameraAndLook) {
  Lab lab({});
  Viewer viewer(lab);
  Settings s = preset("start").make();
  s.size = {64, 36};
  lab.open(s.scene);
  viewer.update(s, {}, false);
  const std::string file = written("gbl-drop.gltf", test::triangle_file().gltf());
  viewer.drop(file);
  viewer.update(s, {}, false);
  EXPECT_EQ(s.scene, "builtin:terrain") << "until the file has been read the old scene stays";
  viewer.finish_loading();
  const std::optional<Viewer::Opened> opened = viewer.take_opened(s);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->file, file);
  EXPECT_EQ(opened->settings.scene, file);
  EXPECT_EQ(opened->settings.size, s.size);
  EXPECT_EQ(opened->settings.shading.model, ShadingModel::ggx);
  EXPECT_FALSE(opened->settings.camera == s.camera);
  EXPECT_FALSE(viewer.take_opened(s)) << "once";
  viewer.update(opened->settings, {}, false);
  EXPECT_EQ(lab.drawn().scene, file);
}

TEST_F(Drop, AFileThatCannotBeReadLeavesTheSceneAndSaysWhy) {
  Lab lab({});
  Viewer viewer(lab);
  Settings s = preset("start").make();
  s.size = {64, 36};
  lab.open(s.scene);
  viewer.update(s, {}, false);
  viewer.drop(written("gbl-bad.gltf", "{\"asset\": 3"));
  viewer.finish_loading();
  EXPECT_FALSE(viewer.take_opened(s));
  EXPECT_NE(viewer.input(0).message.find("gbl-bad.gltf"), std::string::npos) << viewer.input(0).message;
  viewer.update(s, {}, false);
  EXPECT_EQ(lab.drawn().scene, "builtin:terrain");
}

class DropState : public Drop {
 protected:
  void SetUp() override {
    Drop::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
    viewer_ = std::make_unique<Viewer>(*lab_);
    now_ = preset("start").make();
    now_.size = {64, 36};
    lab_->open(now_.scene);
    viewer_->update(now_, {}, false);
  }
  std::optional<Viewer::Opened> drop(const std::string& file) {
    viewer_->drop(file);
    viewer_->finish_loading();
    return viewer_->take_opened(now_);
  }
  std::string message() const { return viewer_->input(0).message; }
  std::unique_ptr<Lab> lab_;
  std::unique_ptr<Viewer> viewer_;
  Settings now_;
};

TEST_F(DropState, APictureBringsAllItsSettingsAndItsSceneButNotItsSize) {
  Settings kept = preset("nclgl").make();
  kept.scene = "builtin:room";
  kept.view.main = "normal";
  const std::string file = (fs::temp_directory_path() / "gbl-drop.png").string();
  write_png(file, {{1, 1}, {1, 2, 3, 255}}, {{kSettingsKey, settings_text(kept)}});
  const auto opened = drop(file);
  ASSERT_TRUE(opened) << message();
  EXPECT_EQ(opened->file, file);
  EXPECT_TRUE(opened->whole);
  kept.size = now_.size;
  EXPECT_EQ(opened->settings, kept);
  EXPECT_EQ(lab_->scene_name(), "builtin:room");
  EXPECT_TRUE(contains(message(), "gbl-drop.png")) << message();
  EXPECT_FALSE(viewer_->take_opened(now_)) << "once";
}

TEST_F(DropState, WhatThisDeviceLacksGivesWayAndIsSaid) {
  FeatureSet without;
  without.add(Feature::clip_control);
  viewer_.reset();
  lab_ = std::make_unique<Lab>(without);
  viewer_ = std::make_unique<Viewer>(*lab_);
  lab_->open(now_.scene);
  viewer_->update(now_, {}, false);
  Settings kept = preset("exact").make();
  const auto opened = drop(written("gbl-drop-exact.json", settings_text(kept)));
  ASSERT_TRUE(opened) << message();
  kept.depth.format = DepthFormat::d32f, kept.size = now_.size;
  EXPECT_EQ(opened->settings, kept);
  EXPECT_TRUE(contains(message(), "depth.format: d32f stands in for d32f-reversed")) << message();
  viewer_->update(opened->settings, {}, false);
  EXPECT_EQ(lab_->drawn().depth.format, DepthFormat::d32f);
}

TEST_F(DropState, SettingsWhoseSceneIsGoneChangeNothing) {
  Settings kept = now_;
  kept.scene = "/gone/model.glb";
  EXPECT_FALSE(drop(written("gbl-drop.json", settings_text(kept))));
  EXPECT_TRUE(contains(message(), "/gone/model.glb")) << message();
  EXPECT_EQ(lab_->scene_name(), now_.scene);
  viewer_->update(now_, {}, false);
  EXPECT_FALSE(viewer_->busy() && lab_->drawn().scene != now_.scene);
}

TEST_F(DropState, ARigLightsTheSceneAtHand) {
  const std::string file = written("gbl-drop-rig.json", R"({"version": 1, "lights": [
      {"kind": "point", "position": [0, 2, 0], "candela": 40}]})");
  const auto opened = drop(file);
  ASSERT_TRUE(opened) << message();
  Settings expected = now_;
  expected.lights.rig = file;
  expected.lights.source = LightSource::rig;
  EXPECT_EQ(opened->settings, expected);
  EXPECT_FALSE(opened->whole);
  EXPECT_TRUE(contains(message(), "1 light")) << message();
}

TEST_F(DropState, ARigWaitsForTheModelThatIsBeingRead) {
  viewer_->drop(written("gbl-drop.gltf", test::triangle_file().gltf()));
  viewer_->drop(written("gbl-drop-rig.json", R"({"version": 1, "lights": []})"));
  EXPECT_TRUE(contains(message(), "still being read")) << message();
  viewer_->finish_loading();
  const auto opened = viewer_->take_opened(now_);
  ASSERT_TRUE(opened);
  EXPECT_TRUE(contains(opened->file, "gbl-drop.gltf"));
}

TEST_F(DropState, WhatCannotBeUsedIsSaidAndNothingChanges) {
  EXPECT_FALSE(drop(written("gbl-drop.txt", "text")));
  EXPECT_TRUE(contains(message(), "gbl-drop.txt: is nothing that this program opens")) << message();
  EXPECT_FALSE(drop(fs::temp_directory_path().string()));
  EXPECT_TRUE(contains(message(), "is a folder")) << message();
  EXPECT_FALSE(viewer_->take_opened(now_));
}

}  // namespace
}  // namespace gbl
