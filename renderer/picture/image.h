#pragma once
// A picture of 8-bit RGBA, rows top to bottom, and its file.
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

namespace gbl {

struct Image {
  glm::ivec2 size{0};
  std::vector<uint8_t> rgba;
  bool operator==(const Image&) const = default;
};

// GL's rows come bottom to top.
Image image_from_gl_rows(glm::ivec2 size, std::vector<uint8_t> rgba);

// PNG with text chunks (keyword, text), e.g. the settings that made it. Written to a temporary name and renamed;
// Error(unfinished) if the folder cannot be written. Alpha is dropped: pictures are opaque.
// pixels_per_cm: how large it is to be printed; 0: not said.
using PngText = std::vector<std::pair<std::string, std::string>>;
void write_png(const std::filesystem::path&, const Image&, const PngText& = {}, double pixels_per_cm = 0);
// The same in at most 256 colours (renderer/picture/palette.h).
void write_indexed_png(const std::filesystem::path&, const Image&, const PngText& = {}, double pixels_per_cm = 0);
// The same with 16 bits a channel: rgb of 0..1, cut to it, rows top to bottom.
void write_png16(const std::filesystem::path&, glm::ivec2 size, const std::vector<glm::vec3>& rgb, const PngText& = {});
Image read_png(const std::filesystem::path&);                              // Error(bad_input)
std::string read_png_text(const std::filesystem::path&, const char* key);  // "" if there is none

// Of the PNG text chunks: the settings of a picture, and the figure that it was made of, both as JSON.
inline constexpr const char* kSettingsKey = "gbufferlab-settings";
inline constexpr const char* kFigureKey = "gbufferlab-figure";

}  // namespace gbl
