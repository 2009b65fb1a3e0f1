#pragma once
// FLIP (Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images"), for displayed sRGB pictures.
#include <glm/glm.hpp>
#include <vector>

namespace gbl {

// Both pictures: sRGB-coded 0..1, rows top to bottom, size.x * size.y. Returns the error map, 0..1.
// pixels_per_degree: of the viewer; 67 = a 0.7 m wide 3840-pixel monitor seen from 0.7 m, the paper's default.
std::vector<double> flip(glm::ivec2 size, const std::vector<glm::dvec3>& reference, const std::vector<glm::dvec3>& test,
                         double pixels_per_degree = 67);

}  // namespace gbl
