// OpenEXR is no part of the page.
#include "renderer/picture/exr.h"

#include "renderer/base/error.h"

namespace gbl {
namespace {
[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw Error(ExitCode::bad_input, path.string(), "EXR files are not part of the page", "use the program, or a PNG");
}
}  // namespace

void write_exr(const std::filesystem::path& path, glm::ivec2, const std::vector<ExrChannel>&,
               const std::vector<std::pair<std::string, std::string>>&) {
  refuse(path);
}
ExrPicture read_exr(const std::filesystem::path& path) { refuse(path); }

}  // namespace gbl
