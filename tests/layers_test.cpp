// The layers: core <- gl <- passes <- app, ui beside passes. The link targets keep most of it; headers are kept here.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace gbl {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GBL_ROOT;

// The files directly in a folder that C++ compiles.
std::vector<fs::path> sources(const char* folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(kRoot / folder))
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

struct Rule {
  const char* folder;
  const char* forbidden;  // a regular expression
};

const char* const kGl = "epoxy/.*|GL/.*|GLES.*|EGL/.*|OpenGL/.*|.*\\bgl3?w?\\.h";
const char* const kWindow = "GLFW/.*|.*glfw.*";
const char* const kUi = ".*imgui.*|imstb.*|ui/.*";

const Rule kRules[] = {
    {"renderer", "renderer/gl/.*|renderer/passes/.*|gl/.*|passes/.*|app/.*"},
    {"renderer", kGl},
    {"renderer", kWindow},
    {"renderer", kUi},
    {"renderer/gltf", "renderer/gl/.*|renderer/passes/.*|app/.*"},
    {"renderer/gltf", kGl},
    {"renderer/gltf", kWindow},
    {"renderer/gltf", kUi},
    {"renderer/truth", "renderer/gl/.*|renderer/passes/.*|renderer/study/.*|app/.*"},
    {"renderer/truth", kGl},
    {"renderer/truth", kWindow},
    {"renderer/truth", kUi},
    {"renderer/study", "renderer/gl/.*|renderer/passes/.*|app/.*"},
    {"renderer/study", kGl},
    {"renderer/study", kWindow},
    {"renderer/study", kUi},
    {"renderer/scenes", "renderer/gl/.*|renderer/passes/.*|app/.*"},
    {"renderer/scenes", kGl},
    {"renderer/scenes", kWindow},
    {"renderer/scenes", kUi},
    {"renderer/gl",
     "renderer/passes/.*|passes/.*|app/.*|renderer/(scene|settings|options|lights|presets|views|camera).*"},
    {"renderer/gl", kWindow},
    {"renderer/gl", kUi},
    {"renderer/passes", "app/.*"},
    {"renderer/passes", kWindow},
    {"renderer/passes", kUi},
    {"ui", "renderer/gl/.*|renderer/passes/.*|gl/.*|passes/.*|app/.*"},
    {"ui", kGl},
    {"ui", kWindow},
};

TEST(Layers, NoFileIncludesWhatIsAboveItsLayer) {
  for (const Rule& rule : kRules) {
    const std::regex forbidden(rule.forbidden);
    const std::vector<fs::path> files = sources(rule.folder);
    EXPECT_FALSE(files.empty()) << rule.folder;
    for (const fs::path& file : files)
      for (const std::string& name : includes_of(file))
        EXPECT_FALSE(std::regex_match(name, forbidden)) << file << " includes " << name;
  }
}

TEST(Layers, OwnHeadersAreNamedFromTheRoot) {
  for (const char* folder : {"renderer", "renderer/gltf", "renderer/scenes", "renderer/truth", "renderer/study",
                             "renderer/gl", "renderer/passes", "ui", "app", "tests", "tests/fuzz"})
    for (const fs::path& file : sources(folder))
      for (const std::string& name : includes_of(file)) {
        const bool ours_by_short_name = fs::exists(file.parent_path() / name) || name.rfind("..", 0) == 0;
        EXPECT_FALSE(ours_by_short_name) << file << " includes " << name;
      }
}

TEST(Layers, EveryFolderWithSourcesIsJudged) {
  const std::vector<std::string> known = {"renderer",
                                          "renderer/gltf",
                                          "renderer/scenes",
                                          "renderer/truth",
                                          "renderer/study",
                                          "renderer/gl",
                                          "renderer/passes",
                                          "ui",
                                          "app",
                                          "tests",
                                          "tests/fuzz"};
  for (const char* top : {"renderer", "ui", "app", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      const fs::path e = entry.path().extension();
      if (e != ".h" && e != ".cpp") continue;
      const std::string folder = fs::relative(entry.path().parent_path(), kRoot).generic_string();
      EXPECT_TRUE(std::count(known.begin(), known.end(), folder)) << entry.path();
    }
}

TEST(Layers, IncludeLinesAreFoundInTheirUsualForms) {
  std::istringstream text(
      "#include <epoxy/gl.h>\n  #  include \"ui/ui.h\"  // why\n// #include \"app/lab.h\"\nx #include <y>\n#include "
      "TABLE\n");
  EXPECT_EQ(includes(text), (std::vector<std::string>{"epoxy/gl.h", "ui/ui.h"}));
  for (const char* name : {"epoxy/gl.h", "GL/gl.h", "GLES3/gl3.h", "EGL/egl.h"})
    EXPECT_TRUE(std::regex_match(name, std::regex(kGl))) << name;
  for (const char* name : {"glm/glm.hpp", "renderer/gltf_json.h", "renderer/estimate.h"})
    EXPECT_FALSE(std::regex_match(name, std::regex(kGl))) << name;
}

}  // namespace
}  // namespace gbl
