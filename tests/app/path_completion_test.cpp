// What a typed path can become, in a folder made for it.
#include "app/path_completion.h"

#include <cstdlib>
#include <fstream>

#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class Completions : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"moon.glb", "moose.GLTF", "mood.json", "mouse.png", "movie.mp4", ".hidden.glb", "ü.glb"})
      std::ofstream(folder_ / name) << "x";
    fs::create_directories(folder_ / "models");
    fs::create_directories(folder_ / ".secret");
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  TemporaryFolder folder_{"completion"};
};

TEST_F(Completions, AreFoldersAndFilesThatCanBeOpened) {
  const ui::PathInput in = completions(at("mo"));
  EXPECT_EQ(in.asked, at("mo"));
  EXPECT_EQ(in.matches, (Names{"models/", "mood.json", "moon.glb", "moose.GLTF", "mouse.png"}));
  EXPECT_EQ(in.completed, at("mo"));
  EXPECT_EQ(completions(at("moo")).matches, (Names{"mood.json", "moon.glb", "moose.GLTF"}));
  EXPECT_EQ(completions(at("mod")).completed, at("models/"));
  EXPECT_EQ(completions(at("mou")).completed, at("mouse.png"));
  EXPECT_EQ(completions(at("movie")).matches, Names{});
  EXPECT_EQ(completions(at("movie")).completed, at("movie"));
}

TEST_F(Completions, HiddenOnesAreForWhoeverTypesTheDot) {
  EXPECT_EQ(completions(at("")).matches.size(), 6u);
  EXPECT_EQ(completions(at(".")).matches, (Names{".hidden.glb", ".secret/"}));
}

TEST_F(Completions, AFolderIsOneWithAndWithoutItsSlash) {
  EXPECT_TRUE(completions(at("models")).folder);
  EXPECT_TRUE(completions(at("models/")).folder);
  EXPECT_FALSE(completions(at("moon.glb")).folder);
  EXPECT_FALSE(completions("").folder);
}

TEST_F(Completions, AFolderThatCannotBeReadIsSaid) {
  const ui::PathInput in = completions(at("none/x"));
  EXPECT_TRUE(contains(in.note, "none/ cannot be read")) << in.note;
  EXPECT_EQ(in.completed, at("none/x"));
}

TEST_F(Completions, ATildeIsHome) {
  setenv("HOME", folder_.path().c_str(), 1);
  EXPECT_EQ(at_home("~/moon.glb"), at("moon.glb"));
  EXPECT_EQ(at_home("~"), folder_.path());
  EXPECT_EQ(at_home("a~/b"), "a~/b");
  EXPECT_EQ(completions("~/mou").completed, "~/mouse.png");
}

// No letter is cut in half, and a name that no text can hold is not offered.
TEST_F(Completions, NamesAreTexts) {
  std::ofstream(folder_ / "\xff.glb") << "x";
  std::ofstream(folder_ / "ä.glb") << "x";  // begins with the same byte as ü
  EXPECT_EQ(completions(at("")).matches.size(), 7u);
  fs::remove_all(folder_ / "models");
  for (const char* name : {"moon.glb", "moose.GLTF", "mood.json", "mouse.png"}) fs::remove(folder_ / name);
  EXPECT_EQ(completions(at("")).completed, at(""));
}

}  // namespace
}  // namespace gbl
