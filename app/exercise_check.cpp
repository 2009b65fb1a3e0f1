#include "app/exercise_check.h"

#include <fmt/format.h>
#include <iostream>
#include <iterator>
#include <unistd.h>

#include "app/child_process.h"
#include "app/exercise_bench.h"
#include "app/file_opening.h"
#include "app/headless.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kStandardInput = "standard input";

// What comes by standard input as a file, for as long as this lives.
class InputFile {
 public:
  explicit InputFile(const char* ending) {
    std::string name = (fs::temp_directory_path() / "gbufferlab-answer-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw Error(ExitCode::unfinished, name, "cannot be made", "set TMPDIR to a folder that can be written");
    folder_ = name;
    std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    if (text.empty()) throw Error(ExitCode::bad_input, kStandardInput, "is empty", "give an answer");
    write_text_file(path(ending), text);
    path_ = path(ending);
  }
  ~InputFile() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path(const char* ending) const { return (folder_ / fmt::format("answer.{}", ending)).string(); }
  fs::path folder_;
  std::string path_;
};

// The child's line without its program's name, and with what the user calls the file.
std::string complaint(std::string text, const std::string& file, const std::string& shown) {
  constexpr std::string_view kName = "gbufferlab: ";
  const size_t last = text.find(kName);
  if (last != std::string::npos) text = text.substr(last + kName.size());
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (file != shown)
    for (size_t at = text.find(file); at != std::string::npos; at = text.find(file, at + shown.size()))
      text.replace(at, file.size(), shown);
  return text;
}

ExerciseVerdict not_ended(const std::string& how, const char* hint) { return {false, how, how, hint}; }

ExerciseVerdict check_file(const Exercise& e, const std::string& file, const std::string& shown,
                           const CheckWishes& wishes) {
  read_answer(e, file);  // what is no answer is refused at once, without a driver
  if (!needs_gl(e)) return check_here(e, file, wishes);
  std::vector<std::string> words = {"exercise", e.id, "--check", file, "--json", "--here"};
  if (!wishes.without.empty()) words.insert(words.end(), {"--without", wishes.without});
  if (wishes.api == gl::Api::es3) words.insert(words.end(), {"--gl", "es3"});
  const ChildResult child = run_child(words, wishes.limit_s);
  if (child.timed_out)
    return not_ended(fmt::format("did not end within {:g} s", wishes.limit_s),
                     "a loop that never ends, or far too much work for each pixel");
  if (child.signal != 0)
    return not_ended(fmt::format("ended by signal {}", child.signal), "the driver does not survive this code");
  const auto code = static_cast<ExitCode>(child.exit_code);
  if (code != ExitCode::done && code != ExitCode::check_failed)
    throw Error(code, "", complaint(child.err, file, shown));
  return verdict_of_json(parse_json(child.out, shown));
}

}  // namespace

Answer read_answer(const Exercise& e, const std::string& file) {
  if (e.answer == AnswerKind::settings && is_picture(file)) return answer_of_state(e, read_state(file), file);
  return parse_answer(e, read_text_file(file, kMostShaderBytes), file);
}

ExerciseVerdict check_here(const Exercise& e, const std::string& file, const CheckWishes& wishes) {
  const Answer answer = read_answer(e, file);
  if (!needs_gl(e)) return judge_answer(e, answer, {});
  const HeadlessContext context(wishes.api);
  return ExerciseBench(parse_features(wishes.without)).judge(e, answer);
}

ExerciseVerdict check_answer(const Exercise& e, const std::string& file, const CheckWishes& wishes) {
  if (file != "-") return check_file(e, file, file, wishes);
  const InputFile input(ending_of(e));
  try {
    return check_file(e, input.path(), std::string(kStandardInput), wishes);
  } catch (const Error& error) {
    throw Error(error.code(), "", complaint(error.what(), input.path(), std::string(kStandardInput)));
  }
}

}  // namespace gbl
