#pragma once
// A class's answers: FOLDER/STUDENT/EXERCISE.json (.glsl, .txt, .png), or FOLDER/STUDENT-EXERCISE.json.
#include <functional>

#include "app/exercise_check.h"

namespace gbl {

struct GradeFile {
  std::string student, exercise;  // as the file is named; the exercise need not exist
  std::filesystem::path path;
};
// By student and exercise. Error(bad_input): no such folder. Other files than answers are left out.
std::vector<GradeFile> answers_in(const std::filesystem::path& folder);

struct GradeRow {
  std::string student, exercise;
  bool right = false;
  std::string measure, note;
};
// Never throws for what is wrong with an answer: that is its row.
GradeRow grade(const GradeFile&, const CheckWishes&);

// Lines of RFC 4180.
inline constexpr const char* kGradeHeader = "student,exercise,right,measure,note\n";
std::string csv_line(const GradeRow&);

}  // namespace gbl
