#include "renderer/study/page/thumbnails.h"

#include <fstream>
#include <iterator>

#include "renderer/base/files.h"

namespace gbl {
namespace {

constexpr int kQuality = 75;             // of the JPEG: blocks are not seen at this size
constexpr size_t kMostBytes = 24 << 10;  // of a file; noise of this size needs about 12 KiB

uint8_t step_of(double codes) {
  size_t step = 1;
  while (step + 1 < kErrorSteps.size() && !(codes < kErrorSteps[step + 1].from_codes)) ++step;
  return static_cast<uint8_t>(step);
}

std::string bytes_of(const std::filesystem::path& path, std::string_view magic) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(kMostBytes + 1, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(file.gcount()));
  return bytes.size() <= kMostBytes && bytes.starts_with(magic) ? bytes : "";
}

}  // namespace

IndexedImage error_map(const Truth& truth, std::span<const glm::vec3> lit, const Display& display, glm::ivec2 size) {
  IndexedImage map{size, {}, std::vector<uint8_t>(static_cast<size_t>(size.x) * static_cast<size_t>(size.y), 0)};
  for (const ErrorStep& s : kErrorSteps) map.palette.push_back(s.colour);
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    const auto width = static_cast<size_t>(truth.size.x);
    const size_t x = i % width * static_cast<size_t>(size.x) / width;
    const size_t y = i / width * static_cast<size_t>(size.y) / static_cast<size_t>(truth.size.y);
    uint8_t& code = map.index[y * static_cast<size_t>(size.x) + x];
    code = std::max(code, step_of(255 * display_difference(display, lit[i], displayed(display, truth.lit[i]))));
  }
  return map;
}

Thumbnails make_thumbnails(const Image& picture, const Truth& truth, std::span<const glm::vec3> lit,
                           const Display& display) {
  const glm::ivec2 size = size_within(picture.size, kThumbnailSize);
  return {jpeg_bytes(shrunk(picture, size), kQuality), png_bytes(error_map(truth, lit, display, size))};
}

std::filesystem::path thumbnail_folder(const std::filesystem::path& study_folder) { return study_folder / "thumbs"; }

void write_thumbnails(const std::filesystem::path& study_folder, const std::string& key, const Thumbnails& t) {
  const std::filesystem::path folder = thumbnail_folder(study_folder);
  make_folder(folder);
  write_text_file(folder / (key + ".jpg"), t.picture);
  write_text_file(folder / (key + ".png"), t.error_map);
}

Thumbnails read_thumbnails(const std::filesystem::path& study_folder, const std::string& key) {
  const std::filesystem::path folder = thumbnail_folder(study_folder);
  return {bytes_of(folder / (key + ".jpg"), "\xff\xd8\xff"), bytes_of(folder / (key + ".png"), "\x89PNG")};
}

}  // namespace gbl
