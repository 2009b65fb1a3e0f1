#include "app/exercise_bench.h"

#include "renderer/frame/validate.h"
#include "renderer/passes/function_runner.h"

namespace gbl {
namespace {

std::vector<glm::vec4> run_glsl(const Answer& answer, const GlslCheck& check, std::span<const GlslInput> inputs) {
  std::vector<glm::vec4> a, b;
  for (const GlslInput& in : inputs) a.push_back(in.a), b.push_back(in.b);
  return call_glsl(answer.text, answer.where, check.call, a, b);
}

}  // namespace

ExerciseVerdict ExerciseBench::judge(const Exercise& exercise, const Answer& answer) {
  const auto measure = [&](const Settings& drawn, const Settings& meant) {
    require_valid(drawn, bench_.limits());
    return bench_.measure(drawn, meant);
  };
  return judge_answer(exercise, answer, {measure, run_glsl});
}

}  // namespace gbl
