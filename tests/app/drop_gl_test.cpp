// A file dropped on the window, through the functions that the window calls.
#include <filesystem>
#include <fstream>

#include "app/viewer.h"
#include "renderer/options/presets.h"
#include "tests/gl_fixture.h"
#include "tests/gltf/gltf_fixture.h"

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
  const std::optional<Settings> opened = viewer.take_opened(s);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->scene, file);
  EXPECT_EQ(opened->size, s.size);
  EXPECT_EQ(opened->shading.model, ShadingModel::ggx);
  EXPECT_FALSE(opened->camera == s.camera);
  EXPECT_FALSE(viewer.take_opened(s)) << "once";
  viewer.update(*opened, {}, false);
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

}  // namespace
}  // namespace gbl
