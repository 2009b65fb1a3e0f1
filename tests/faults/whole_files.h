#pragma once
// Is what stands in a folder whole? Each file is read to its end by what it is.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/picture/exr.h"
#include "renderer/picture/image.h"

namespace gbl::test {

// By their paths below the folder.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> out;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error))
    if (entry.is_regular_file())
      out[std::filesystem::relative(entry.path(), folder).string()] =
          entry.file_size() > 0 ? read_text_file(entry.path()) : "";
  return out;
}

inline bool is_temporary_name(std::string_view name) { return name.find(".gbufferlab-") != std::string_view::npos; }

// Names that are only there while a file is written.
inline std::string temporaries(const std::map<std::string, std::string>& files) {
  std::string out;
  for (const auto& [name, text] : files)
    if (is_temporary_name(name)) out += name + " ";
  return out;
}

// Outside quotes, so many cells a line as the first line has.
inline bool whole_table(std::string_view text) {
  size_t cells = 1, first = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++cells;
    if (c != '\n' || quoted) continue;
    if (first == 0) first = cells;
    if (cells != first) return false;
    cells = 1;
  }
  return first > 1 && text.ends_with('\n');
}

// Text that was made to its end, by how it ends.
inline bool ends_whole(std::string_view text, std::string_view end) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  return text.ends_with(end);
}

// Every line but the last, which may be torn where a program was killed.
inline bool whole_lines(std::string_view text) {
  for (size_t end = 0; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1))
    if (!Json::accept(text.substr(0, end))) return false;
  return true;
}

inline bool is_whole(const std::filesystem::path& path, std::string_view text) {
  const std::string kind = path.extension().string();
  if (kind == ".png") return read_png(path).size.x > 0;  // throws where it ends early
  if (kind == ".exr") return read_exr(path).size.x > 0;
  if (kind == ".json") return Json::accept(text);
  if (kind == ".jsonl") return whole_lines(text);
  if (kind == ".csv") return whole_table(text);
  if (kind == ".svg") return ends_whole(text, "</svg>");
  if (kind == ".html") return ends_whole(text, "</html>");
  if (kind == ".jpg") return ends_whole(text, "\xff\xd9");
  if (kind == ".gif") return ends_whole(text, ";");
  return (kind == ".md" || kind == ".tex" || kind == ".glsl") && text.ends_with('\n');
}

// Which files are not; empty: all are whole. Temporary ones are not looked at.
inline std::string not_whole(const std::filesystem::path& folder) {
  std::string out;
  for (const auto& [name, text] : files_in(folder)) {
    if (is_temporary_name(name)) continue;
    try {
      if (!is_whole(folder / name, text)) out += name + " ";
    } catch (const std::exception& e) {
      out += std::string(e.what()) + " ";
    }
  }
  return out;
}

}  // namespace gbl::test
