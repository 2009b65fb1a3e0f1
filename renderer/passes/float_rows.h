#pragma once
// Float textures as they are read back, turned into pictures.
#include <cstddef>
#include <glm/glm.hpp>
#include <type_traits>
#include <vector>

namespace gbl {

// GL's rows run bottom to top, pictures' top to bottom.
// Four floats a texel, of which `Texel` takes the first; of `float` one.
template <class Texel>
std::vector<Texel> rows_from_top(glm::ivec2 size, const std::vector<float>& values) {
  const auto width = static_cast<size_t>(size.x), height = static_cast<size_t>(size.y);
  std::vector<Texel> out(width * height);
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x) {
      const size_t from = (height - 1 - y) * width + x;
      Texel& to = out[y * width + x];
      if constexpr (std::is_same_v<Texel, float>)
        to = values[from];
      else
        for (int k = 0; k < to.length(); ++k) to[k] = values[4 * from + static_cast<size_t>(k)];
    }
  return out;
}

}  // namespace gbl
