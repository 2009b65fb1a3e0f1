#pragma once
// A normal from its code alone, as the shaders decode it.
#include "renderer/gbuffer/normal_encoding.h"

namespace gbl {

// code: what stored_code() gives; whole numbers, or the floats of a float format.
glm::dvec3 normal_of_code(NormalEncoding, const glm::dvec3& code);

}  // namespace gbl
