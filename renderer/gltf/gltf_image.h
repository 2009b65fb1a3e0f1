#pragma once
// Encoded images to texels: PNG and JPEG, what glTF allows (specification 3.8.2). stb_image is seen by one file.
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gltf/gltf_job.h"

namespace gbl::gltf {

struct ImageSize {
  int width = 0, height = 0;
};

// From the header alone, within the limits; Broken.
ImageSize image_size(std::span<const uint8_t> encoded);

// RGBA, 8 bits each, rows top to bottom: grey, palette and 16 bits are converted. Broken.
std::vector<uint8_t> decode_image(std::span<const uint8_t> encoded, ImageSize expected);

}  // namespace gbl::gltf
