#include "app/exercise_grade.h"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "renderer/base/error.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEndings[] = {".json", ".glsl", ".txt", ".png"};

// Those that `exercise NAME -o` writes beside an answer are none.
bool is_answer(const fs::path& file) {
  const std::string ending = file.extension().string(), name = file.filename().string();
  return !name.starts_with('.') && name != "state.json" &&
         std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

bool is_exercise(std::string_view name, const std::vector<std::string>& known) {
  return std::find(known.begin(), known.end(), name) != known.end();
}

// "ada-quad-space": names of students and exercises may both hold hyphens, so the longest exercise wins.
GradeFile split_name(const fs::path& file, const std::vector<std::string>& known) {
  const std::string stem = file.stem().string();
  std::string exercise;
  for (const std::string& id : known)
    if (stem.size() > id.size() + 1 && stem.ends_with("-" + id) && id.size() > exercise.size()) exercise = id;
  if (!exercise.empty()) return {stem.substr(0, stem.size() - exercise.size() - 1), exercise, file};
  const size_t hyphen = std::min(stem.find('-'), stem.size());
  return {stem.substr(0, hyphen), hyphen < stem.size() ? stem.substr(hyphen + 1) : "", file};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::vector<GradeFile> answers_in(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw Error(ExitCode::bad_input, folder.string(), "is not a folder", "give the folder of the class's answers");
  const std::vector<std::string> known = exercise_ids();
  std::vector<GradeFile> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && is_answer(entry.path())) out.push_back(split_name(entry.path(), known));
    if (!entry.is_directory() || name.starts_with('.')) continue;
    for (const auto& file : fs::directory_iterator(entry.path(), error)) {
      const std::string stem = file.path().stem().string();
      const bool picture = file.path().extension() == ".png";  // the lab writes others, too
      if (file.is_regular_file() && is_answer(file.path()) && (!picture || is_exercise(stem, known)))
        out.push_back({name, stem, file.path()});
    }
  }
  std::sort(out.begin(), out.end(), [](const GradeFile& a, const GradeFile& b) {
    return std::tie(a.student, a.exercise, a.path) < std::tie(b.student, b.exercise, b.path);
  });
  return out;
}

GradeRow grade(const GradeFile& file, const CheckWishes& wishes) {
  GradeRow row{file.student, file.exercise};
  try {
    const ExerciseVerdict v = check_answer(load_exercise(file.exercise), file.path.string(), wishes);
    row.right = v.right, row.measure = v.measured, row.note = v.off;
  } catch (const Error& e) {
    if (e.code() == ExitCode::no_gl) throw;  // nothing can be judged here
    row.note = e.what();
  } catch (const std::exception& e) {
    row.note = printable(e.what(), 300);
  }
  return row;
}

std::string csv_line(const GradeRow& r) {
  return fmt::format("{},{},{},{},{}\n", quoted(r.student), quoted(r.exercise), r.right ? "yes" : "no",
                     quoted(r.measure), quoted(r.note));
}

}  // namespace gbl
