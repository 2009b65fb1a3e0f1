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

// Below renderer/ only these two rooms draw.
TEST(Layers, NoFileIncludesWhatIsAboveItsLayer) {
  const auto check = [](const std::string& file, const fs::path& path, const char* forbidden) {
    for (const std::string& name : includes_of(path))
      EXPECT_FALSE(std::regex_match(name, std::regex(forbidden))) << file << " includes " << name;
  };
  for (const char* top : {"renderer", "ui"})
    for (const fs::path& path : sources(top)) {
      const std::string file = fs::relative(path, kRoot).generic_string();
      check(file, path, "app/.*|tests/.*");
      check(file, path, kWindow);
      if (!draws(file)) check(file, path, kGl), check(file, path, kDrawing);
      if (file.rfind("ui/", 0) != 0) check(file, path, kUi);
      if (file.rfind("renderer/gl/", 0) == 0) check(file, path, "renderer/(passes|scene|options|light|inspect)/.*");
      if (file.rfind("renderer/truth/", 0) == 0) check(file, path, "renderer/study/.*");
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
