// The only file that sees stb_image (slow to compile). Its functions are static: other libraries bring their own.
#include "renderer/gltf/gltf_image.h"

#include <fmt/format.h>

#include "renderer/gltf/gltf_limits.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gbl::gltf {

static_assert(STBI_MAX_DIMENSIONS == kMaxImageSide);

namespace {

int stb_length(std::span<const uint8_t> encoded) {
  if (encoded.empty()) throw Broken("it is empty");
  if (encoded.size() > kMaxFileBytes) throw Broken("it is too long");
  return static_cast<int>(encoded.size());
}

}  // namespace

ImageSize image_size(std::span<const uint8_t> encoded) {
  ImageSize size;
  int channels = 0;
  if (!stbi_info_from_memory(encoded.data(), stb_length(encoded), &size.width, &size.height, &channels))
    throw Broken("it is neither PNG nor JPEG");
  const auto width = static_cast<uint64_t>(size.width), height = static_cast<uint64_t>(size.height);
  if (size.width < 1 || size.height < 1 || width > kMaxImageSide || height > kMaxImageSide ||
      width * height > kMaxImageTexels)
    throw Broken(fmt::format("it has {} x {} texels, at most {} a side and {} in all are read", size.width, size.height,
                             kMaxImageSide, kMaxImageTexels));
  size.bits = stbi_is_16_bit_from_memory(encoded.data(), stb_length(encoded)) ? 16 : 8;
  return size;
}

namespace {

// load: stb's function for this kind of channel.
template <class Channel, class Load>
std::vector<Channel> decoded(std::span<const uint8_t> encoded, ImageSize expected, Load load) {
  ImageSize size;
  int channels = 0;
  Channel* texels = load(encoded.data(), stb_length(encoded), &size.width, &size.height, &channels, 4);
  if (!texels) throw Broken(fmt::format("it cannot be decoded ({})", stbi_failure_reason()));
  std::vector<Channel> rgba;
  const bool same = size.width == expected.width && size.height == expected.height;
  if (same) rgba.assign(texels, texels + static_cast<size_t>(size.width) * static_cast<size_t>(size.height) * 4);
  stbi_image_free(texels);
  if (!same) throw Broken("it is not of the size its header says");
  return rgba;
}

}  // namespace

Texels decode_image(std::span<const uint8_t> encoded, ImageSize expected) {
  if (expected.bits == 16) return {{}, decoded<uint16_t>(encoded, expected, stbi_load_16_from_memory)};
  return {decoded<uint8_t>(encoded, expected, stbi_load_from_memory), {}};
}

}  // namespace gbl::gltf
