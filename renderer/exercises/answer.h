#pragma once
// A student's answer, read from a file of the kind that the exercise asks for. Errors name file, line and column.
//   choice, number, pixel   {"exercise": "quad-space", "answer": "screen"}   … 1.25   … [120, 44]
//   settings                the same with a patch, {"range.threshold": 0.01}; or a state that the lab wrote; or lines of
//                           PATH=VALUE, as --set takes them
//   glsl, layout            a file of GLSL
#include <string>
#include <string_view>
#include <vector>

#include "renderer/exercises/exercise.h"

namespace gbl {

struct Answer {
  std::string where;  // its file, as messages name it
  std::string choice;
  double number = 0;
  glm::ivec2 pixel{0};
  std::vector<Assignment> set;
  std::string text;  // GLSL
  std::string path;  // of a layout
};

// Error(bad_input): not such a file; a choice or an option that there is not; a pixel outside.
Answer parse_answer(const Exercise&, std::string_view text, const std::string& where);

// What a state changes of the exercise's own; how large the picture is, its time and what is looked at are no part of it.
Answer answer_of_state(const Exercise&, const Settings&, const std::string& where);

// The ending of the file, "json" or "glsl", and what a student begins with.
const char* ending_of(const Exercise&);
std::string template_of(const Exercise&);

}  // namespace gbl
