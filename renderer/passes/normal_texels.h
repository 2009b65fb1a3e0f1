#pragma once
// Directions the way of a frame's normals: packed by the shaders' own text, stored in the attachment's format, read back.
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/options/settings.h"

namespace gbl {

struct NormalTexels {
  std::vector<glm::vec4> codes, decoded;  // one for each direction
};

// directions: unit vectors, w = 0, size.x * size.y of them. The encoding and its space are the settings'; a
// frame block must be bound: normal.space=view reads it, and WebGL wants one in any case. Needs a current context; waits for the GPU.
NormalTexels normals_through_gpu(const Settings&, std::span<const glm::vec4> directions, glm::ivec2 size);

}  // namespace gbl
