// Of every exercise the right answer passes and three wrong ones fail: tests/exercises/answers/EXERCISE.
#include <fmt/format.h>

#include "app/exercise_bench.h"
#include "app/exercise_check.h"
#include "renderer/base/files.h"
#include "tests/gl_fixture.h"
#include "tests/test_paths.h"

namespace gbl::test {
namespace {

namespace fs = std::filesystem;

class ExerciseAnswers : public GlTest {};

fs::path answer_file(const Exercise& e, const std::string& name) {
  return source_folder() / "tests/exercises/answers" / e.id / fmt::format("{}.{}", name, ending_of(e));
}

TEST_F(ExerciseAnswers, TheRightOnePassesAndThreeWrongOnesFail) {
  ExerciseBench bench({});
  for (const Exercise& e : load_exercises()) {
    const auto judged = [&](const std::string& name) {
      return bench.judge(e, read_answer(e, answer_file(e, name).string()));
    };
    const ExerciseVerdict right = judged("right");
    EXPECT_TRUE(right.right) << e.id << ": " << right.measured << "; " << right.off;
    EXPECT_TRUE(right.off.empty() && right.hint.empty()) << e.id;
    for (int i = 1; i <= 3; ++i) {
      const ExerciseVerdict wrong = judged(fmt::format("wrong{}", i));
      EXPECT_FALSE(wrong.right) << e.id << ", wrong" << i << ": " << wrong.measured;
      EXPECT_FALSE(wrong.off.empty()) << e.id << ", wrong" << i;
      EXPECT_FALSE(wrong.hint.empty()) << e.id << ", wrong" << i;
    }
  }
}

// What a student begins with is no answer yet.
TEST_F(ExerciseAnswers, TheFileThatOneBeginsWithIsWrong) {
  ExerciseBench bench({});
  const fs::path folder = build_folder() / "exercise-starts";
  fs::create_directories(folder);
  for (const Exercise& e : load_exercises()) {
    if (e.start.empty()) continue;
    const fs::path file = folder / fmt::format("{}.glsl", e.id);
    write_text_file(file, template_of(e));
    EXPECT_FALSE(bench.judge(e, read_answer(e, file.string())).right) << e.id;
  }
}

}  // namespace
}  // namespace gbl::test
