// Layouts from files in studies: each is a case of its own, and none is taken for a layout of the lab's.
#include <fmt/format.h>
#include <set>

#include "renderer/base/files.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/study/study_spec.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

DeviceLimits everything() {
  DeviceLimits limits;
  for (const FeatureRow& f : kFeatures) limits.features.add(f.feature);
  return limits;
}

// A scene without anything, by whatever name; what the looks of the built-in ones say is applied all the same.
std::shared_ptr<const Scene> empty_scene(const std::string& name) {
  auto scene = std::make_shared<Scene>();
  scene->name = name;
  scene->camera.position = {1, 2, 3};
  return scene;
}

class LayoutFilesInStudies : public ::testing::Test {
 protected:
  TemporaryFolder folder{"layout-file-study"};
  std::string file(const char* name, const char* holds) {
    write_text_file(folder / name, fmt::format("// attachments: material RGBA8 {{ {} }}\n", holds));
    return (folder / name).string();
  }
  std::string asked_for(const char* name, const char* holds) {
    const std::string path = file(name, holds);
    allow_layout_file(path);
    return path;
  }
  StudyPlan plan_of(const std::string& text) {
    return expand(parse_study(text, "own.json"), empty_scene, everything());
  }
};

TEST_F(LayoutFilesInStudies, MayBeWhatVaries) {
  const std::string a = asked_for("a.glsl", "rgb: albedo"), b = asked_for("b.glsl", "rgb: albedo; a: roughness");
  const StudyPlan plan = plan_of(fmt::format(R"({{"version": 1, "name": "own", "base": {{"layout": "exact"}},
      "permute": {{"layout-file": ["{}", "{}"]}}}})",
                                             a, b));
  ASSERT_EQ(plan.cases.size(), 2u);
  EXPECT_EQ(plan.cases[0].settings.layout_file, name_layout_file(a));
  EXPECT_EQ(plan.cases[1].settings.layout_file, name_layout_file(b)) << "the base's layout does not put it aside";
  EXPECT_NE(plan.cases[0].id, plan.cases[1].id);
}

TEST_F(LayoutFilesInStudies, AreNotRunUnasked) {
  const std::string mine = file("unasked.glsl", "rgb: albedo");
  const std::string line = error_line(ExitCode::bad_input, [&] {
    plan_of(fmt::format(R"({{"version": 1, "name": "own", "permute": {{"layout-file": ["{}"]}}}})", mine));
  });
  EXPECT_TRUE(contains(line, mine + ": is shader text, named by a file and asked for by nobody")) << line;
  EXPECT_TRUE(contains(line, "--run-layouts")) << line;
}

TEST_F(LayoutFilesInStudies, GiveWayWhereTheLayoutVaries) {
  const StudySpec spec = parse_study(R"({"version": 1, "name": "own", "base": {"scene": "builtin:room"},
      "permute": [{"layout": ["exact", "compact"]}, {"normal.encoding": ["oct8", "oct16"]}]})",
                                     "own.json");
  const std::string mine = asked_for("mine.glsl", "rgb: albedo");
  const StudyPlan plan = expand(with_given(spec, {}, {{"layout-file", mine}}), empty_scene, everything());
  ASSERT_EQ(plan.cases.size(), 4u);
  std::multiset<std::string> files;
  for (const StudyCase& c : plan.cases) files.insert(c.settings.layout_file);
  EXPECT_EQ(files.count(""), 2u) << "layouts of the lab's own";
  EXPECT_EQ(files.count(name_layout_file(mine)), 2u);
}

}  // namespace
}  // namespace gbl
