#pragma once
// What a row of a study looks like, small: its picture, and a map of its errors in colours that mean the same in every
// row. Written when the row is measured, beside the journal, so that a study that goes on and one that is merged have them.
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "renderer/picture/small_files.h"
#include "renderer/truth/measure.h"

namespace gbl {

inline constexpr glm::ivec2 kThumbnailSize{128, 72};  // at most; the shape is the picture's

// One step of the map's colours: errors from so many codes of 255 as displayed.
struct ErrorStep {
  double from_codes;
  std::array<uint8_t, 3> colour;
  const char* words;
};
// Brighter is worse, in grey as well: stops of the colour map "magma". The first is where no surface is seen.
inline constexpr std::array<ErrorStep, 7> kErrorSteps = {{{-1, {128, 128, 128}, "no surface"},
                                                          {0, {12, 8, 38}, "below half a code"},
                                                          {0.5, {66, 15, 117}, "from half a code of 255"},
                                                          {1, {140, 41, 129}, "from 1"},
                                                          {4, {214, 69, 108}, "from 4"},
                                                          {16, {254, 159, 109}, "from 16"},
                                                          {64, {252, 253, 191}, "from 64 codes"}}};

// Each pixel the worst of those below it.
IndexedImage error_map(const Truth&, std::span<const glm::vec3> lit, const Display&, glm::ivec2 size);

struct Thumbnails {
  std::string picture;    // JPEG
  std::string error_map;  // PNG
};
Thumbnails make_thumbnails(const Image& picture, const Truth&, std::span<const glm::vec3> lit, const Display&);

// In FOLDER/thumbs: KEY.jpg and KEY.png, each by a temporary name. Empty: there is none, or what stands there cannot be a thumbnail.
std::filesystem::path thumbnail_folder(const std::filesystem::path& study_folder);
void write_thumbnails(const std::filesystem::path& study_folder, const std::string& key, const Thumbnails&);
Thumbnails read_thumbnails(const std::filesystem::path& study_folder, const std::string& key);

}  // namespace gbl
