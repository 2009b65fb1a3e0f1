#pragma once
// Commands that write files, each over in a second or two, and one of each kind of file among them.
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/files.h"

namespace gbl::test {

struct QuickCommand {
  std::string name;
  std::vector<std::string> words;
  const char* journal = nullptr;  // where it goes on by what this file holds
  std::vector<std::string> into(const std::filesystem::path& folder) const {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"-o", folder.string()});
    return all;
  }
};

inline constexpr const char* kQuickStudy = R"({"version": 1, "name": "quick", "label": "quick",
  "base": {"scene": "builtin:layers", "size": "64x36"}, "permute": {"lights": [1, 2, 3, 4, 5, 6]},
  "x": "bytes_per_pixel", "y": "rmse_linear", "family": "layout"})";

// A picture with its numbers, a film and a drawing.
inline constexpr const char* kQuickFigures = R"({"version": 1, "title": "Quick", "figures": [
  {"id": "still", "title": "T", "caption": "C.", "scene": "builtin:yard", "size": [96, 54], "set": {"lights.count": 4},
   "panels": [{"view": "final"}, {"view": "depth"}]},
  {"id": "film", "title": "T", "caption": "C.", "scene": "builtin:yard", "size": [96, 54], "set": {"lights.count": 4},
   "columns": 1, "panels": [{"view": "depth"}],
   "frames": {"count": 3, "keys": [{"camera": "20,5,40:0,0:45"}, {"camera": "20,5,20:0,0:45"}]}},
  {"id": "drawn", "title": "T", "caption": "C.", "drawing": "light-from-side", "preset": "start"}]})";

inline constexpr const char* kQuickLesson =
    R"({"version": 1, "order": 1, "title": "Quick", "preset": "start", "steps": [
  {"say": "One light.", "set": {"lights.count": 1}, "view": "final", "layout": "large", "question": "Why?",
   "answer": "Because."}]})";

// The files that they read go into the folder.
inline std::vector<QuickCommand> quick_commands(const std::filesystem::path& folder) {
  const auto given = [&](const char* name, const char* text) {
    write_text_file(folder / name, text);
    return (folder / name).string();
  };
  return {{"study", {"study", given("study.json", kQuickStudy)}, "rows.jsonl"},
          {"stability",
           {"stability", "volume-level", "--scene", "builtin:layers", "--lights", "4", "--size", "64x36"},
           "points.jsonl"},
          {"figures", {"figures", given("figures.json", kQuickFigures), "--exr"}},
          {"render",
           {"render", "--scene", "builtin:yard", "--size", "160x90", "--lights", "4", "--only", "final,normal",
            "--sheet", "--exr", "--png16"}},
          {"handout", {"handout", given("lesson.json", kQuickLesson)}},
          {"exercise", {"exercise", "pack-smaller"}}};
}

}  // namespace gbl::test
