#include "renderer/picture/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/limits.h"
#include "renderer/picture/exr_header.h"

namespace gbl {
namespace {

// The library writes where write_file() says, so that nobody sees half a file.
class Stream : public Imf::OStream {
 public:
  Stream(std::FILE* file, const std::string& name) : OStream(name.c_str()), file_(file) {}
  void write(const char bytes[], int n) override {
    if (std::fwrite(bytes, 1, static_cast<size_t>(n), file_) != static_cast<size_t>(n))
      throw std::runtime_error(std::strerror(errno));
  }
  uint64_t tellp() override { return static_cast<uint64_t>(std::ftell(file_)); }
  void seekp(uint64_t at) override {
    if (std::fseek(file_, static_cast<long>(at), SEEK_SET) != 0) throw std::runtime_error(std::strerror(errno));
  }

 private:
  std::FILE* file_;
};

std::vector<uint32_t> whole_numbers(const std::vector<float>& values) {
  std::vector<uint32_t> out(values.size());
  for (size_t i = 0; i < values.size(); ++i) out[i] = static_cast<uint32_t>(std::lround(std::max(values[i], 0.0f)));
  return out;
}

}  // namespace

void write_exr(const std::filesystem::path& path, glm::ivec2 size, const std::vector<ExrChannel>& channels,
               const std::vector<std::pair<std::string, std::string>>& texts) {
  Imf::Header header(size.x, size.y);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, text] : texts) header.insert(name, Imf::StringAttribute(text));
  Imf::FrameBuffer buffer;
  std::vector<std::vector<uint32_t>> whole;
  whole.reserve(channels.size());
  for (const ExrChannel& c : channels) {
    const Imf::PixelType type = c.whole ? Imf::UINT : Imf::FLOAT;
    header.channels().insert(c.name, Imf::Channel(type));
    const void* first = c.values.data();
    if (c.whole) first = whole.emplace_back(whole_numbers(c.values)).data();
    // The library writes through no pointer of a frame buffer that is written from.
    buffer.insert(c.name, Imf::Slice(type, static_cast<char*>(const_cast<void*>(first)), sizeof(float),
                                     sizeof(float) * static_cast<size_t>(size.x)));
  }
  write_file(path, [&](std::FILE* file) {
    Stream stream(file, path.string());
    Imf::OutputFile out(stream, header);
    out.setFrameBuffer(buffer);
    out.writePixels(size.y);
  });
}

static std::string read_start(const std::filesystem::path& path, size_t most) {
  require_regular(path);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::min<size_t>(most, std::filesystem::file_size(path)), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

ExrPicture read_exr(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& what) {
    return Error(ExitCode::bad_input, path.string(), what, "give an OpenEXR file with channels R, G and B");
  };
  try {
    require_sound_exr_header(read_start(path, kMostExrHeaderBytes), std::filesystem::file_size(path), path.string());
    // The library takes memory for what a header claims before it can be asked how much that is.
    Imf::Header::setMaxImageSize(kMostPictureSide, kMostPictureSide);
    Imf::Header::setMaxTileSize(kMostPictureSide, kMostPictureSide);
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const int64_t width = int64_t(window.max.x) - window.min.x + 1, height = int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMostPictureSide || height > kMostPictureSide)
      throw refuse(fmt::format("is {} x {} pixels large", width, height));
    const auto pixels = static_cast<size_t>(width * height);
    require_plausible(path, pixels * sizeof(glm::vec3), 1 << 14);  // what is flat is packed densely
    ExrPicture out{{static_cast<int>(width), static_cast<int>(height)}, {}};
    out.rgb.resize(pixels);
    Imf::FrameBuffer buffer;
    auto* first = reinterpret_cast<char*>(out.rgb.data());
    // The library counts from the origin, wherever the window begins.
    const std::ptrdiff_t before =
        (std::ptrdiff_t(window.min.y) * width + window.min.x) * std::ptrdiff_t(sizeof(glm::vec3));
    for (int k = 0; k < 3; ++k) {
      const char name[] = {"RGB"[k], 0};
      if (!file.header().channels().findChannel(name)) throw refuse(fmt::format("has no channel {}", name));
      buffer.insert(name, Imf::Slice(Imf::FLOAT, first - before + std::ptrdiff_t(sizeof(float)) * k, sizeof(glm::vec3),
                                     sizeof(glm::vec3) * static_cast<size_t>(width)));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return out;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw refuse(fmt::format("cannot be read ({})", e.what()));
  }
}

}  // namespace gbl
