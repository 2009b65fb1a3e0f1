// The layers: core <- gl <- passes <- app, ui beside passes. The link targets keep most of it; headers are kept here.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/test_paths.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = test::source_folder();

// The files below a folder that C++ compiles.
std::vector<fs::path> sources(const std::string& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
    if (const fs::path e = entry.path().extension(); e == ".h" || e == ".cpp") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

// What stands between the quotes or brackets of its #include lines.
std::vector<std::string> includes(std::istream& text) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*["<]([^">]+)[">].*)");
  std::vector<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    if (std::regex_match(line, match, kInclude)) found.push_back(match[1]);
  return found;
}

std::vector<std::string> includes_of(const fs::path& file) {
  std::ifstream text(file);
  EXPECT_TRUE(text) << file;
  return includes(text);
}

const char* const kGl = "epoxy/.*|GL/.*|GLES.*|EGL/.*|OpenGL/.*|.*\\bgl3?w?\\.h";
const char* const kWindow = "GLFW/.*|.*glfw.*";
const char* const kUi = ".*imgui.*|imstb.*|ui/.*";
const char* const kDrawing = "renderer/gl/.*|renderer/passes/.*|gl/.*|passes/.*";

bool draws(const std::string& file) { return std::regex_match(file, std::regex(kDrawing)); }

// The rooms, lowest first: a file includes its own room and lower ones, never a higher one. So no two rooms know each
// other. docs/architecture.md shows the same order.
const char* const kRooms[] = {
    "shaders",
    "renderer/base",
    "renderer/pitfalls",
    "renderer/rows",
    "renderer/picture",
    "renderer/scene",
    "renderer/gbuffer",
    "renderer/light",
    "renderer/reflection",
    "renderer/options",
    "renderer/gltf",
    "renderer/scenes",
    "renderer/frame",
    "renderer/inspect",
    "renderer/lessons",
    "renderer/truth",
    "renderer/opening",
    "renderer/figures",
    "renderer/study/rows",
    "renderer/study/charts",
    "renderer/study/page",
    "renderer/study",
    "renderer/study/stability",
    "renderer/study/pitfalls",
    "renderer/study/advice",
    "renderer/exercises",
    "renderer/gl",
    "renderer/passes",
    "ui",
    "ui/panels",
    "app",
};

std::string room_of(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.generic_string();
}

int level_of(const std::string& room) {
  const auto found = std::find(std::begin(kRooms), std::end(kRooms), room);
  return found == std::end(kRooms) ? -1 : static_cast<int>(found - std::begin(kRooms));
}

TEST(Layers, ARoomKnowsOnlyLowerRooms) {
  for (const char* top : {"renderer", "ui", "app"})
    for (const fs::path& path : sources(top)) {
      const std::string file = fs::relative(path, kRoot).generic_string();
      const int level = level_of(room_of(file));
      EXPECT_GE(level, 0) << file << " stands in no room of the list";
      for (const std::string& name : includes_of(path))
        EXPECT_LE(level_of(room_of(name)), level) << file << " includes " << name << ", of a higher room";
    }
}

// What the order alone does not keep: only two rooms draw, the window stays in app, and ui draws with ImGui alone.
TEST(Layers, GlTheWindowAndImGuiStayWhereTheyBelong) {
  const auto check = [](const std::string& file, const fs::path& path, const char* forbidden) {
    for (const std::string& name : includes_of(path))
      EXPECT_FALSE(std::regex_match(name, std::regex(forbidden))) << file << " includes " << name;
  };
  for (const char* top : {"renderer", "ui"})
    for (const fs::path& path : sources(top)) {
      const std::string file = fs::relative(path, kRoot).generic_string();
      check(file, path, kWindow);
      if (!draws(file)) check(file, path, kGl);
      if (file.rfind("ui/", 0) == 0) check(file, path, kDrawing);
      if (file.rfind("renderer/", 0) == 0) check(file, path, kUi);
    }
}

// Who reads or writes a file knows JSON; a header that did would hand it to all who include that.
TEST(Layers, NoHeaderBringsJsonAlong) {
  for (const char* top : {"renderer", "ui", "app"})
    for (const fs::path& path : sources(top)) {
      const std::string file = fs::relative(path, kRoot).generic_string();
      if (path.extension() != ".h" || file == "renderer/base/json.h") continue;
      for (const std::string& name : includes_of(path))
        EXPECT_TRUE(name != "nlohmann/json.hpp" && name != "renderer/base/json.h") << file << " includes " << name;
    }
}

TEST(Layers, OwnHeadersAreNamedFromTheRoot) {
  for (const char* top : {"renderer", "ui", "app", "tests"})
    for (const fs::path& file : sources(top))
      for (const std::string& name : includes_of(file)) {
        const bool ours_by_short_name = fs::exists(file.parent_path() / name) || name.rfind("..", 0) == 0;
        EXPECT_FALSE(ours_by_short_name) << file << " includes " << name;
      }
}

TEST(Layers, IncludeLinesAreFoundInTheirUsualForms) {
  std::istringstream text(
      "#include <epoxy/gl.h>\n  #  include \"ui/ui.h\"  // why\n// #include \"app/lab.h\"\nx #include <y>\n#include "
      "TABLE\n");
  EXPECT_EQ(includes(text), (std::vector<std::string>{"epoxy/gl.h", "ui/ui.h"}));
  for (const char* name : {"epoxy/gl.h", "GL/gl.h", "GLES3/gl3.h", "EGL/egl.h"})
    EXPECT_TRUE(std::regex_match(name, std::regex(kGl))) << name;
  for (const char* name : {"glm/glm.hpp", "renderer/gltf/gltf_json.h", "renderer/frame/estimate.h"})
    EXPECT_FALSE(std::regex_match(name, std::regex(kGl))) << name;
}

}  // namespace
}  // namespace gbl
