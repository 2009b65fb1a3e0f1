#include "app/state_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>

#include "renderer/base/error.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> folder_in(const char* variable) {
  const char* value = std::getenv(variable);
  if (!value || value[0] != '/') return {};  // a relative path is invalid, and to be ignored: XDG base directories
  return fs::path(value);
}

}  // namespace

std::optional<fs::path> state_folder() {
  std::optional<fs::path> folder = folder_in("XDG_STATE_HOME");
  if (!folder) {
    folder = folder_in("HOME");
    if (folder) *folder /= ".local/state";
  }
  if (folder) *folder /= "gbufferlab";
  return folder;
}

void make_private_folder(const fs::path& folder) {
  if (folder.empty() || fs::is_directory(folder)) return;
  make_private_folder(folder.parent_path());
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    throw Error(ExitCode::unfinished, folder.string(), fmt::format("cannot be made: {}", std::strerror(errno)),
                "set XDG_STATE_HOME to a folder that can be written");
}

}  // namespace gbl
