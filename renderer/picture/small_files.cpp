#include "renderer/picture/small_files.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <png.h>
#include <stdexcept>

#include "renderer/picture/srgb.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace gbl {
namespace {

std::array<double, 256> linear_of_codes() {
  std::array<double, 256> table{};
  for (size_t i = 0; i < table.size(); ++i) table[i] = linear_from_srgb(static_cast<double>(i) / 255);
  return table;
}

// Of `from` pixels those below the i-th of `to`: at least one.
struct Span {
  int begin, end;
};
Span below(int i, int to, int from) {
  const int begin = static_cast<int>(int64_t{i} * from / to), end = static_cast<int>(int64_t{i + 1} * from / to);
  return {begin, std::max(end, begin + 1)};
}

glm::dvec3 mean_of(const Image& image, Span across, Span down) {
  static const std::array<double, 256> kLinear = linear_of_codes();
  glm::dvec3 sum(0);
  for (int y = down.begin; y < down.end; ++y)
    for (int x = across.begin; x < across.end; ++x) {
      const uint8_t* p = &image.rgba[4 * (static_cast<size_t>(y) * static_cast<size_t>(image.size.x) + x)];
      sum += glm::dvec3(kLinear[p[0]], kLinear[p[1]], kLinear[p[2]]);
    }
  return sum / (double(across.end - across.begin) * (down.end - down.begin));
}

[[noreturn]] void on_png_error(png_structp, png_const_charp message) { throw std::runtime_error(message); }
void on_png_warning(png_structp, png_const_charp) {}
void flush_nothing(png_structp) {}

void append_png(png_structp png, png_bytep bytes, size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

}  // namespace

glm::ivec2 size_within(glm::ivec2 size, glm::ivec2 most) {
  const double scale = std::min({1.0, double(most.x) / size.x, double(most.y) / size.y});
  return glm::max(glm::ivec2(1), glm::ivec2(glm::round(scale * glm::dvec2(size))));
}

Image shrunk(const Image& image, glm::ivec2 to) {
  Image small{to, {}};
  small.rgba.reserve(4u * to.x * to.y);
  for (int y = 0; y < to.y; ++y)
    for (int x = 0; x < to.x; ++x) {
      const glm::dvec3 mean = mean_of(image, below(x, to.x, image.size.x), below(y, to.y, image.size.y));
      for (int c = 0; c < 3; ++c)
        small.rgba.push_back(static_cast<uint8_t>(std::lround(255 * srgb_from_linear(mean[c]))));
      small.rgba.push_back(255);
    }
  return small;
}

std::string jpeg_bytes(const Image& image, int quality) {
  std::string bytes;
  const auto append = [](void* to, void* data, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(count));
  };
  if (!stbi_write_jpg_to_func(append, &bytes, image.size.x, image.size.y, 4, image.rgba.data(), quality))
    throw std::runtime_error("a picture cannot be written as JPEG");
  return bytes;
}

std::string png_bytes(const IndexedImage& image) {
  assert(!image.palette.empty() && image.palette.size() <= 16);
  struct Writer {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_png_error, on_png_warning);
    png_infop info = png_create_info_struct(png);
    ~Writer() { png_destroy_write_struct(&png, &info); }
  } writer;
  std::string bytes;
  const png_structp png = writer.png;
  png_set_write_fn(png, &bytes, append_png, flush_nothing);
  png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.size.x), static_cast<png_uint_32>(image.size.y), 4,
               PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (const auto& c : image.palette) palette.push_back({c[0], c[1], c[2]});
  png_set_PLTE(png, writer.info, palette.data(), static_cast<int>(palette.size()));
  png_set_compression_level(png, 9);
  png_write_info(png, writer.info);
  png_set_packing(png);
  const auto width = static_cast<size_t>(image.size.x);
  for (size_t y = 0; y < static_cast<size_t>(image.size.y); ++y) png_write_row(png, &image.index[y * width]);
  png_write_end(png, writer.info);
  return bytes;
}

}  // namespace gbl
