#pragma once
// A picture in at most 256 colours: a third of the bytes of a document's figure.
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/picture/image.h"

namespace gbl {

struct IndexedImage {
  glm::ivec2 size{0};
  std::vector<std::array<uint8_t, 3>> palette;  // 1 to 256
  std::vector<uint8_t> index;                   // of each pixel, rows top to bottom
};

// The colours: a box of all of them is halved along its longest side, again and again, the box with most to gain first (after
// Heckbert 1982, "Color Image Quantization for Frame Buffer Display"). What a pixel is off goes to its neighbours (Floyd and Steinberg
// 1976, "An Adaptive Algorithm for Spatial Grey Scale"), so that means over a few pixels stay.
IndexedImage indexed(const Image&);
Image expanded(const IndexedImage&);

}  // namespace gbl
