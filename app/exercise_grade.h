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

// "student,exercise,right,measure,note" and a line for each row; RFC 4180.
std::string csv_of(std::span<const GradeRow>);

}  // namespace gbl
