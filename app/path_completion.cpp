#include "app/path_completion.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>

#include "app/file_opening.h"
#include "renderer/options/option_value.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

// No letter of it is cut in half: names are UTF-8.
std::string begin_in_common(const std::vector<std::string>& names) {
  const std::string& first = names.front();
  size_t end = first.size();
  for (const std::string& n : names)
    end = std::min(
        end, static_cast<size_t>(std::mismatch(first.begin(), first.end(), n.begin(), n.end()).first - first.begin()));
  while (end > 0 && end < first.size() && (first[end] & 0xC0) == 0x80) --end;
  return first.substr(0, end);
}

// Hidden ones only for whoever types the dot.
bool fits(const std::string& name, const std::string& begin) {
  return name.starts_with(begin) && (name[0] != '.' || begin.starts_with('.')) && writable(name);
}

}  // namespace

std::string at_home(const std::string& path) {
  const char* home = std::getenv("HOME");
  const bool tilde = path == "~" || path.starts_with("~/");
  return tilde && home ? home + path.substr(1) : path;
}

ui::PathInput completions(const std::string& typed) {
  ui::PathInput out{.asked = typed, .completed = typed};
  const size_t name_at = typed.rfind('/') + 1;  // npos + 1 = 0
  const std::string folder = at_home(typed.substr(0, name_at)), begin = typed.substr(name_at);
  std::error_code error;
  out.folder = fs::is_directory(at_home(typed), error);
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!fits(name, begin)) continue;
    std::error_code gone;
    if (entry->is_directory(gone))
      out.matches.push_back(name + "/");
    else if (has_known_ending(name))
      out.matches.push_back(name);
  }
  if (error) out.note = fmt::format("{} cannot be read: {}", folder, error.message());
  std::sort(out.matches.begin(), out.matches.end());
  if (!out.matches.empty()) out.completed = typed.substr(0, name_at) + begin_in_common(out.matches);
  return out;
}

}  // namespace gbl
