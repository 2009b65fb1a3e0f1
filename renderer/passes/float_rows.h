#pragma once
// Float textures as they are read back, turned into pictures.
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace gbl {

// GL's rows run bottom to top, pictures' top to bottom.
template <class Texel>
std::vector<Texel> rows_from_top(glm::ivec2 size, const std::vector<float>& rgba) {
  std::vector<Texel> out(rgba.size() / 4);
  const auto width = static_cast<size_t>(size.x), height = static_cast<size_t>(size.y);
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x) {
      const float* from = &rgba[4 * ((height - 1 - y) * width + x)];
      Texel& to = out[y * width + x];
      for (int k = 0; k < to.length(); ++k) to[k] = from[k];
    }
  return out;
}

}  // namespace gbl
