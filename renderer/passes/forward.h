#pragma once
// Surfaces shaded while they are drawn.
#include "renderer/passes/objects.h"

namespace gbl {

struct ShadedDraw {
  LightOutput output = LightOutput::sum;  // or count
  glm::ivec2 lights{0, 1 << 30};          // from, to; cut to those there are
  bool ambient = true;                    // with ambient light and emission
};

// Into the bound framebuffer. -> draw calls
int draw_shaded_objects(const Frame&, const std::vector<ObjectDraw>&, const ShadedDraw&);

}  // namespace gbl
