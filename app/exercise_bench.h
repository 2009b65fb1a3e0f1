#pragma once
// Judges answers to exercises on the device's current context.
#include "app/pitfall_bench.h"
#include "renderer/exercises/judge_answer.h"

namespace gbl {

class ExerciseBench {
 public:
  explicit ExerciseBench(FeatureSet without) : bench_(renderer_, gl::probe_device(without)) {}
  ExerciseVerdict judge(const Exercise&, const Answer&);  // Error(bad_input): see judge_answer.h

 private:
  Renderer renderer_;
  PitfallBench bench_;
};

}  // namespace gbl
