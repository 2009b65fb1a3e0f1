#pragma once
// What a student's function is called with, and what it should give: inputs and references by name, in double, written
// from the formulas. A new exercise over these is data alone.
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "renderer/exercises/exercise.h"

namespace gbl {

struct GlslInput {
  glm::vec4 a{0}, b{0};  // as the function gets them
};

void require_known(const GlslCheck&);  // Error(bad_input) with the nearest name
std::vector<GlslInput> inputs_of(const GlslCheck&);

struct GlslError {
  double most = 0;  // in the check's measure; infinite: a result is not finite
  GlslInput worst;
};
// results: one for each input, in their order.
GlslError error_of(const GlslCheck&, std::span<const GlslInput>, std::span<const glm::vec4> results);

const char* unit_of_error(const GlslCheck&);  // "degrees"; "" = a share, or none

}  // namespace gbl
