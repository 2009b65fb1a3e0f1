#pragma once
// One answer's file, judged in a process of its own: an endless loop or a driver that crashes is an answer, too.
#include <filesystem>
#include <string>

#include "renderer/base/limits.h"
#include "renderer/exercises/judge_answer.h"
#include "renderer/gl/device.h"

namespace gbl {

struct CheckWishes {
  double limit_s = kAnswerSeconds;
  std::string without = {};  // features, as --without has them
  gl::Api api = gl::Api::core;
};

// "-": standard input. Error(bad_input): it is no answer; with file, line and column.
ExerciseVerdict check_answer(const Exercise&, const std::string& file, const CheckWishes&);

// The same in this process.
Answer read_answer(const Exercise&, const std::string& file);
ExerciseVerdict check_here(const Exercise&, const std::string& file, const CheckWishes&);

}  // namespace gbl
