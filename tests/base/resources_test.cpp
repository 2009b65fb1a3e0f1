#include "renderer/base/resources.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> files_in(const std::string& folder, const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(test::source_folder() / folder))
    if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension))
      names.push_back(fs::relative(entry.path(), test::source_folder()).generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

// Each test leaves the override as it found it.
class Resources : public testing::Test {
 protected:
  void TearDown() override { set_override_folder(before_); }
  const fs::path before_ = override_folder();
};

TEST_F(Resources, NamesAreTheFilesOfTheSourceFolder) {
  EXPECT_EQ(resource_names("shaders/"), files_in("shaders", ""));
  EXPECT_EQ(resource_names("assets/lessons/"), files_in("assets/lessons", ".json"));
  EXPECT_EQ(resource_names("assets/studies/"), files_in("assets/studies", ".json"));
  EXPECT_EQ(resource_names("fonts/"), std::vector<std::string>{"fonts/DejaVuSans.ttf"});
  EXPECT_TRUE(resource_names("no-such/").empty());
  const std::vector<std::string> all = resource_names("");
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

TEST_F(Resources, EmbeddedBytesAreTheFiles) {
  for (const std::string& name : resource_names("")) {
    if (name.rfind("fonts/", 0) == 0) continue;
    EXPECT_TRUE(embedded_bytes(name) == bytes_of(test::source_folder() / name)) << name;
  }
  EXPECT_GT(embedded_bytes("fonts/DejaVuSans.ttf").size(), 100000u);
  EXPECT_EQ(embedded_bytes("fonts/DejaVuSans.ttf").substr(0, 4), std::string_view("\0\1\0\0", 4));  // TrueType
}

TEST_F(Resources, WithoutAFolderTheEmbeddedOnesAreRead) {
  set_override_folder({});
  EXPECT_EQ(override_folder(), fs::path());
  for (const std::string& name : resource_names("")) EXPECT_TRUE(resource(name) == embedded_bytes(name)) << name;
  EXPECT_EQ(shaders_stamp(), 0);
}

TEST_F(Resources, TheSourceFolderOverridesByDefault) {
  EXPECT_EQ(fs::weakly_canonical(before_), fs::weakly_canonical(test::source_folder()));
  EXPECT_NE(shaders_stamp(), 0);
}

TEST_F(Resources, AFileInTheFolderWinsAndTheRestStaysEmbedded) {
  const TemporaryFolder folder("resources");
  fs::create_directories(folder / "shaders");
  std::ofstream(folder / "shaders/combine.frag", std::ios::binary) << "edited\r\n";
  std::ofstream(folder / "shaders/new.glsl") << "new";
  set_override_folder(folder.path());
  EXPECT_EQ(resource("shaders/combine.frag"), "edited\r\n");
  EXPECT_EQ(resource("shaders/new.glsl"), "new");  // a file that a shader under work includes
  EXPECT_EQ(resource("shaders/shared.h"), embedded_bytes("shaders/shared.h"));
  EXPECT_NE(embedded_bytes("shaders/combine.frag"), "edited\r\n");
}

TEST_F(Resources, UnknownNamesAreAnErrorWithTheName) {
  set_override_folder({});
  for (const char* name : {"shaders/combine", "combine.frag", "", "/shaders/combine.frag"}) {
    EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { resource(name); }), "no such resource")) << name;
    EXPECT_TRUE(contains(error_line(ExitCode::bad_input, [&] { embedded_bytes(name); }), name)) << name;
  }
}

TEST_F(Resources, TheStampChangesWhenAShaderIsSaved) {
  const TemporaryFolder folder("resources");
  fs::create_directories(folder / "shaders/layouts");
  const char* const files[] = {"shaders/a.frag", "shaders/layouts/b.glsl"};
  for (const char* file : files) std::ofstream(folder / file) << "1";
  set_override_folder(folder.path());
  int seconds = 0;
  for (const char* file : files) {
    const long long before = shaders_stamp();
    EXPECT_NE(before, 0);
    EXPECT_EQ(shaders_stamp(), before);
    fs::last_write_time(folder / file, fs::last_write_time(folder / file) + std::chrono::seconds(++seconds));
    EXPECT_GT(shaders_stamp(), before) << file;
  }
  set_override_folder(folder / "no-such-folder");
  EXPECT_EQ(shaders_stamp(), 0);
}

}  // namespace
}  // namespace gbl
