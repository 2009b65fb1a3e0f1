#pragma once
// Is an answer right, how far is it off, and what helps on? Data in, words out; drawing and running GLSL are handed in.
#include <functional>
#include <span>

#include "renderer/base/json_fwd.h"
#include "renderer/exercises/answer.h"
#include "renderer/exercises/glsl_tasks.h"
#include "renderer/study/pitfalls/pitfall_metrics.h"

namespace gbl {

struct ExerciseVerdict {
  bool right = false;
  std::string measured;  // the numbers that were judged
  std::string off;       // how far, and from what; empty: nothing is off
  std::string hint;      // one, where it is wrong
};

struct ExerciseTools {
  // Draws `drawn` and measures it against the reference of `meant`. Error(bad_input): it cannot be drawn.
  std::function<PitfallEvidence(const Settings& drawn, const Settings& meant)> measure;
  // The results of `call` for each input. Error(bad_input) with the student's own line where it does not compile.
  std::function<std::vector<glm::vec4>(const Answer&, const GlslCheck&, std::span<const GlslInput>)> run_glsl;
};

bool needs_gl(const Exercise&);  // else the tools are not called
ExerciseVerdict judge_answer(const Exercise&, const Answer&, const ExerciseTools&);

Json to_json(const ExerciseVerdict&);
ExerciseVerdict verdict_of_json(const Json&);

}  // namespace gbl
