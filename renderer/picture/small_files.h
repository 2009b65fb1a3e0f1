#pragma once
// Small pictures as the bytes of a file, for pages that hold them. stb_image_write is seen by one file.
#include <string>

#include "renderer/picture/palette.h"

namespace gbl {

// The largest size of this shape within `most`; never larger than `size`, at least 1 pixel a side.
glm::ivec2 size_within(glm::ivec2 size, glm::ivec2 most);

// Each pixel the mean of those below it, taken in linear light.
Image shrunk(const Image&, glm::ivec2 to);

std::string jpeg_bytes(const Image&, int quality);  // quality: 1..100

std::string png_bytes(const IndexedImage&);  // of at most 16 colours, 4 bits a pixel

}  // namespace gbl
