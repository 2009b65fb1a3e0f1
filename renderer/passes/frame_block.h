#pragma once
// The uniform block and constants that shaders and C++ share: the same text, compiled by both.
#include <glm/glm.hpp>

namespace gbl::shared {
using glm::ivec4, glm::mat4, glm::vec4;
#include "shaders/shared.h"
static_assert(sizeof(FrameBlock) == 4 * 64 + 10 * 16 + 2 * 16, "std140: mat4 64 bytes, vec4 16 bytes, no gaps");
}  // namespace gbl::shared
