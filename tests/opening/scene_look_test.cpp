// Scenes and presets combine by one rule: a scene brings what is true, a preset how it is drawn.
#include "renderer/opening/scene_look.h"

#include <gtest/gtest.h>

#include "renderer/frame/resolve.h"
#include "renderer/frame/validate.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "renderer/scenes/builtin_scenes.h"
#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {
namespace {

FeatureSet all_features() {
  FeatureSet all;
  for (const FeatureRow& f : kFeatures) all.add(f.feature);
  return all;
}

// Scenes as far as looks go: without their meshes.
Scene bare(const BuiltinScene& row) {
  Scene s;
  s.name = row.id;
  s.lights.resize(1);
  return s;
}

bool same_group(Group group, const Settings& a, const Settings& b) {
  for (const Option& o : options())
    if (o.group == group && o.get(a) != o.get(b)) return false;
  return true;
}

TEST(SceneLook, EveryPresetShowsEverySceneAndKeepsHowItDraws) {
  for (const Preset& p : presets())
    for (const BuiltinScene& row : builtin_scenes()) {
      Settings s = p.make();
      apply_scene(s, std::string("builtin:") + row.id, bare(row));
      for (const Problem& problem : validate(s, {all_features()}))
        ADD_FAILURE() << p.id << " in " << row.id << ": " << problem.path << " " << problem.sentence;
      EXPECT_TRUE(same_group(Group::method, s, p.make())) << p.id << " in " << row.id;
    }
}

TEST(SceneLook, LooksNameOnlyWhatIsTrueAndDrawingsOnlyHowItIsDrawn) {
  for (const BuiltinScene& row : builtin_scenes()) {
    Settings s = preset("compact").make();
    apply_scene(s, std::string("builtin:") + row.id, bare(row));
    EXPECT_TRUE(same_group(Group::method, s, preset("compact").make())) << row.id;
    const Settings before = s;
    apply_drawing(s, std::string("builtin:") + row.id);
    EXPECT_TRUE(same_group(Group::truth, s, before)) << row.id;
  }
}

TEST(SceneLook, NoSceneKeepsTheLookOfTheOneBefore) {
  const Settings start = preset("start").make();
  const Settings room = moved_to(start, "builtin:room", *open_scene("builtin:room"));
  EXPECT_NE(room.shading.model, start.shading.model);
  Settings back = moved_to(room, "builtin:terrain", *open_scene("builtin:terrain"));
  back.view = start.view;
  back.camera = start.camera;
  EXPECT_EQ(back, start);
}

TEST(SceneLook, WhatWasChosenOfTheDrawingStaysAndWhatWasNotComesWithTheScene) {
  const Settings start = preset("start").make();
  EXPECT_EQ(moved_to(start, "builtin:room", *open_scene("builtin:room")).layout, Layout::auto_);
  Settings chosen = start;
  chosen.normal.encoding = NormalEncoding::oct8;
  const Settings moved = moved_to(chosen, "builtin:room", *open_scene("builtin:room"));
  EXPECT_TRUE(same_group(Group::method, moved, chosen));
}

TEST(SceneLook, FilesAreDrawnAsTheLabAdvises) {
  const ScratchFolder folder("look");
  const GltfFile file = triangle_file();
  const std::string path = folder.write("triangle.gltf", bytes_of(file.gltf())).string();
  const std::shared_ptr<const Scene> scene = open_scene(path);
  Settings s = preset("start").make();
  apply_scene(s, path, *scene);
  apply_drawing(s, path);
  EXPECT_EQ(s.layout, Layout::auto_);
  EXPECT_EQ(s.lights.method, LightMethod::auto_);
  EXPECT_EQ(s.depth.format, DepthFormat::auto_);
  EXPECT_EQ(s.attenuation, Attenuation::gltf);
  EXPECT_TRUE(validate(s, {all_features()}).empty());
}

TEST(SceneLook, AddedLightsAreSaidWhereTheyAreShown) {
  const ScratchFolder folder("studio");
  const std::string path = folder.write("dark.gltf", bytes_of(triangle_file().gltf())).string();
  const std::shared_ptr<const Scene> scene = open_scene(path);
  const auto said = [&](LightSource lights) {
    for (const std::string& note : notes_of(*scene, lights))
      if (note.find("no lights") != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(said(LightSource::scene));
  EXPECT_FALSE(said(LightSource::rig));
  EXPECT_FALSE(said(LightSource::generated));
}

TEST(SceneLook, AFileThatShowsNothingSaysWhy) {
  const ScratchFolder folder("unseen");
  GltfFile file = triangle_file();
  const auto said = [&](const std::string& part) {
    const Scene scene = *open_scene(folder.write("unseen.gltf", bytes_of(file.gltf())).string());
    return has_warning(scene, part);
  };
  EXPECT_FALSE(said("camera sees")) << "the triangle faces +Z, and so does the camera that is made for it";
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"zfar", 100}}}});
  const int eye = file.add("nodes", {{"camera", 0}, {"translation", {0.3, 0.3, -4}}, {"rotation", {0, 1, 0, 0}}});
  file.doc["scenes"][0]["nodes"].push_back(eye);
  EXPECT_TRUE(said("face away from it"));
  file.node(eye)["rotation"] = {0, 0, 0, 1};
  EXPECT_TRUE(said("camera sees none of its surfaces"));
}

TEST(ChooseDepth, IsReversedWhereItCanBeAndElseBeginsWithTheScene) {
  Scene scene;
  scene.bounds = {{-1, -1, -1}, {1, 1, 1}};
  Resolved r;
  r.settings.depth.format = DepthFormat::auto_;
  r.settings.camera.position = {0, 0, 11};
  r.settings.camera.near = 1e-3, r.settings.camera.far = 100;
  Resolved plain = r;
  choose_depth(r, scene, all_features());
  EXPECT_EQ(r.settings.depth.format, DepthFormat::d32f_reversed);
  EXPECT_EQ(r.settings.camera.near, 1e-3);
  choose_depth(plain, scene, {});
  EXPECT_EQ(plain.settings.depth.format, DepthFormat::d32f);
  EXPECT_NEAR(plain.settings.camera.near, 10, 0.02);
  EXPECT_LT(plain.settings.camera.near, 10);
  plain.settings.depth.format = DepthFormat::auto_;
  plain.settings.camera.position = {0, 0, 0.5};  // within the scene
  plain.settings.camera.near = 1e-3;
  choose_depth(plain, scene, {});
  EXPECT_EQ(plain.settings.camera.near, 1e-3);
}

}  // namespace
}  // namespace gbl::test
