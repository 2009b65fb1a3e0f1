#pragma once
// Calls a function of GLSL once for each of a list of inputs, a pixel each.
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace gbl {

// text: the file with the function, which messages call `shown`. call: a vec4 in terms of the inputs vec4 a and b. As many
// b as a. Needs a current context; waits for the GPU. Error(bad_input) with file and line if it does not compile.
std::vector<glm::vec4> call_glsl(const std::string& text, const std::string& shown, const std::string& call,
                                 std::span<const glm::vec4> a, std::span<const glm::vec4> b);

}  // namespace gbl
