#pragma once
// Encoded images to texels: PNG and JPEG, what glTF allows (specification 3.8.2). stb_image is seen by one file.
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gltf/gltf_job.h"

namespace gbl::gltf {

struct ImageSize {
  int width = 0, height = 0;
  int bits = 8;  // a channel: 8 or 16
};

// RGBA, rows top to bottom; one of the two is empty.
struct Texels {
  std::vector<uint8_t> bytes;
  std::vector<uint16_t> words;  // of images with 16 bits a channel
};

// From the header alone, within the limits; Broken.
ImageSize image_size(std::span<const uint8_t> encoded);

// Grey and palette are converted. Broken.
Texels decode_image(std::span<const uint8_t> encoded, ImageSize expected);

}  // namespace gbl::gltf
