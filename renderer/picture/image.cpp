#include "renderer/picture/image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <png.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/limits.h"
#include "renderer/picture/palette.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

[[noreturn]] void on_png_error(png_structp, png_const_charp message) { throw std::runtime_error(message); }
void on_png_warning(png_structp, png_const_charp) {}

// What is said of a picture beside its pixels.
struct PngHead {
  glm::ivec2 size;
  int bits = 8;  // a channel, or an index
  const PngText& texts;
  double pixels_per_cm = 0;
  const std::vector<std::array<uint8_t, 3>>* palette = nullptr;  // null: three channels a pixel
};

void set_texts(png_structp png, png_infop info, const PngText& texts) {
  std::vector<png_text> chunks;
  for (const auto& [key, text] : texts) {
    png_text chunk{};  // tEXt is Latin-1, iTXt is UTF-8
    const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return c >= 0; });
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(text.c_str());
    chunks.push_back(chunk);
  }
  if (!chunks.empty()) png_set_text(png, info, chunks.data(), static_cast<int>(chunks.size()));
}

void set_palette(png_structp png, png_infop info, const std::vector<std::array<uint8_t, 3>>& palette) {
  std::vector<png_color> colours;
  for (const auto& c : palette) colours.push_back({c[0], c[1], c[2]});
  png_set_PLTE(png, info, colours.data(), static_cast<int>(colours.size()));
}

// row(y) gives the bytes of a line, three channels or one index a pixel, the high byte first.
template <class Row>
void encode_png(std::FILE* file, const PngHead& head, Row row) {
  struct Writer {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_png_error, on_png_warning);
    png_infop info = png_create_info_struct(png);
    ~Writer() { png_destroy_write_struct(&png, &info); }
  } writer;
  const png_structp png = writer.png;
  const png_infop info = writer.info;
  png_init_io(png, file);
  const auto width = static_cast<png_uint_32>(head.size.x), height = static_cast<png_uint_32>(head.size.y);
  png_set_IHDR(png, info, width, height, head.bits, head.palette ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (head.palette) {
    set_palette(png, info, *head.palette);
    png_set_compression_level(png, 9);
    png_set_filter(png, 0, PNG_FILTER_NONE);  // neighbouring indices say nothing of each other
  } else {
    png_set_compression_level(png, 2);  // a third of the default's time for a tenth more bytes
    png_set_filter(png, 0, PNG_FILTER_SUB);
  }
  if (head.pixels_per_cm > 0) {
    const auto per_metre = static_cast<png_uint_32>(std::lround(100 * head.pixels_per_cm));
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
  set_texts(png, info, head.texts);
  png_write_info(png, info);
  for (png_uint_32 y = 0; y < height; ++y) png_write_row(png, row(static_cast<size_t>(y)));
  png_write_end(png, info);
}

// libpng takes memory for what a chunk claims before it reads it: none may claim more than is left of the file.
void require_whole_chunks(std::FILE* file, const fs::path& path) {
  const long begin = std::ftell(file);
  std::fseek(file, 0, SEEK_END);
  const long end = std::ftell(file);
  constexpr long kAround = 12;  // length, name and sum
  uint8_t length[4] = {};
  for (long at = begin; at + kAround <= end;) {
    std::fseek(file, at, SEEK_SET);
    if (std::fread(length, 1, 4, file) != 4) break;
    const long bytes = static_cast<long>(png_get_uint_32(length));
    if (bytes > end - at - kAround) throw Error(ExitCode::bad_input, path.string(), "is cut short, or no PNG");
    at += kAround + bytes;
  }
  std::fseek(file, begin, SEEK_SET);
}

struct PngReader {
  explicit PngReader(const fs::path& path) {
    require_regular(path);
    file.reset(std::fopen(path.c_str(), "rb"));
    uint8_t magic[8] = {};
    if (!file || std::fread(magic, 1, 8, file.get()) != 8 || png_sig_cmp(magic, 0, 8) != 0)
      throw Error(ExitCode::bad_input, path.string(), "is not a PNG that can be read");
    require_whole_chunks(file.get(), path);
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_png_error, on_png_warning);
    info = png_create_info_struct(png);
    png_init_io(png, file.get());
    png_set_sig_bytes(png, 8);
    png_set_user_limits(png, kMostPictureSide, kMostPictureSide);  // a 100-byte file can claim a picture of terabytes
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  File file;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

}  // namespace

Image image_from_gl_rows(glm::ivec2 size, std::vector<uint8_t> rgba) {
  const size_t stride = 4u * size.x;
  for (int y = 0; y < size.y / 2; ++y)
    std::swap_ranges(rgba.begin() + y * stride, rgba.begin() + (y + 1) * stride,
                     rgba.begin() + (size.y - 1 - y) * stride);
  return {size, std::move(rgba)};
}

void write_png(const fs::path& path, const Image& image, const PngText& texts, double pixels_per_cm) {
  const auto width = static_cast<size_t>(image.size.x);
  std::vector<uint8_t> line(3 * width);
  const auto row = [&](size_t y) {
    const uint8_t* from = &image.rgba[4 * width * y];
    for (size_t x = 0; x < width; ++x) std::memcpy(&line[3 * x], from + 4 * x, 3);
    return line.data();
  };
  write_file(path, [&](std::FILE* file) { encode_png(file, {image.size, 8, texts, pixels_per_cm}, row); });
}

void write_indexed_png(const fs::path& path, const Image& image, const PngText& texts, double pixels_per_cm) {
  IndexedImage few = indexed(image);
  const auto row = [&](size_t y) { return &few.index[y * static_cast<size_t>(few.size.x)]; };
  write_file(path, [&](std::FILE* file) { encode_png(file, {few.size, 8, texts, pixels_per_cm, &few.palette}, row); });
}

void write_png16(const fs::path& path, glm::ivec2 size, const std::vector<glm::vec3>& rgb, const PngText& texts) {
  const auto width = static_cast<size_t>(size.x);
  std::vector<uint8_t> line(6 * width);
  const auto row = [&](size_t y) {
    for (size_t i = 0; i < 3 * width; ++i) {
      const float value = rgb[y * width + i / 3][static_cast<glm::length_t>(i % 3)];
      const auto code =
          static_cast<uint16_t>(std::lround(65535 * (value > 0 ? std::min(value, 1.0f) : 0.0f)));  // NaN: 0
      line[2 * i] = static_cast<uint8_t>(code >> 8), line[2 * i + 1] = static_cast<uint8_t>(code & 255);
    }
    return line.data();
  };
  write_file(path, [&](std::FILE* file) { encode_png(file, {size, 16, texts}, row); });
}

Image read_png(const fs::path& path) {
  try {
    PngReader r(path);
    png_read_info(r.png, r.info);
    Image image{{int(png_get_image_width(r.png, r.info)), int(png_get_image_height(r.png, r.info))}, {}};
    const size_t stride = size_t(4) * static_cast<size_t>(image.size.x), height = static_cast<size_t>(image.size.y);
    // Deflate makes nothing 1033 times as small, and a pixel has a bit or more.
    require_plausible(path, stride * height, 32 * 1032);
    png_set_expand(r.png);
    png_set_strip_16(r.png);
    png_set_gray_to_rgb(r.png);
    png_set_add_alpha(r.png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(r.png);
    png_read_update_info(r.png, r.info);
    image.rgba.resize(stride * height);
    std::vector<png_bytep> rows(height);
    for (size_t y = 0; y < height; ++y) rows[y] = &image.rgba[stride * y];
    png_read_image(r.png, rows.data());
    png_read_end(r.png, nullptr);
    return image;
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& e) {
    throw Error(ExitCode::bad_input, path.string(), e.what());
  }
}

std::string read_png_text(const fs::path& path, const char* key) {
  try {
    PngReader r(path);
    png_read_info(r.png, r.info);
    png_textp texts = nullptr;
    const int count = png_get_text(r.png, r.info, &texts, nullptr);
    for (int i = 0; i < count; ++i)
      if (std::strcmp(texts[i].key, key) == 0)
        return {texts[i].text,
                texts[i].compression < PNG_ITXT_COMPRESSION_NONE ? texts[i].text_length : texts[i].itxt_length};
    return "";
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& e) {
    throw Error(ExitCode::bad_input, path.string(), e.what());
  }
}

}  // namespace gbl
