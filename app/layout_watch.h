#pragma once
// A user's layout file is read again when it is saved.
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/gbuffer/layout_file.h"

namespace gbl {

class LayoutWatch {
 public:
  // The name of what is in the file now, where it was saved since the last look.
  std::optional<std::string> saved(const std::string& layout_file) {
    const std::string path(path_of_layout_file(layout_file));
    std::error_code error;
    const auto time = std::filesystem::last_write_time(path, error);
    if (error) return {};
    const bool other = path != path_, newer = time != time_;
    path_ = path, time_ = time;
    return other || !newer ? std::nullopt : std::optional(name_layout_file(path));
  }

 private:
  std::string path_;
  std::filesystem::file_time_type time_;
};

}  // namespace gbl
