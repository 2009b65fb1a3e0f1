#include "renderer/gltf/gltf_decode.h"

#include <atomic>
#include <fmt/format.h>
#include <optional>

#include "renderer/base/threads.h"
#include "renderer/gltf/gltf_accessor.h"
#include "renderer/gltf/gltf_image.h"
#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {
namespace {

struct Encoded {
  Bytes own;                       // of a file or a data URI; else empty
  std::span<const uint8_t> bytes;  // in `own` or in a buffer
  ImageSize size;
  std::string failure;  // "": none
};

Bytes bytes_of_uri(const Source& source, Folder& folder) {
  return is_data_uri(source.uri) ? decode_data_uri(source.uri) : folder.read(source.uri);
}

// Reading is serial (disks and limits are), decoding is not.
Encoded open_image(const Document& document, int image, uint64_t& texture_bytes, size_t copies, Folder& folder) {
  Encoded encoded;
  try {
    if (image < 0) throw Broken("its texture names no image that is read");
    const Source& source = document.images[static_cast<size_t>(image)];
    if (source.view >= 0) {
      encoded.bytes = view_bytes(document, source.view);
    } else {
      if (source.uri.empty()) throw Broken("it has neither a URI nor a buffer view");
      encoded.own = bytes_of_uri(source, folder);
      encoded.bytes = encoded.own;
    }
    encoded.size = image_size(encoded.bytes);
    const uint64_t needed = static_cast<uint64_t>(encoded.size.width) * static_cast<uint64_t>(encoded.size.height) * 4 *
                            copies * (static_cast<uint64_t>(encoded.size.bits) / 8);
    if (needed > kMaxTextureBytes - texture_bytes) throw Broken("all textures together would be too large");
    texture_bytes += needed;
  } catch (const Broken& broken) {
    encoded.failure = broken.what();
  }
  return encoded;
}

// Runs on any thread: each image fills textures of its own, and no exception leaves.
void fill(Scene& scene, const ImageJob& job, Encoded& encoded) {
  if (encoded.failure.empty()) try {
      const auto textures = [&](size_t i) -> Texture& { return scene.textures[static_cast<size_t>(job.textures[i])]; };
      Texels texels = decode_image(encoded.bytes, encoded.size);
      textures(0).rgba = std::move(texels.bytes), textures(0).rgba16 = std::move(texels.words);
      for (size_t i = 0; i < job.textures.size(); ++i) {
        if (i > 0) textures(i).rgba = textures(0).rgba, textures(i).rgba16 = textures(0).rgba16;
        textures(i).size = {encoded.size.width, encoded.size.height};
      }
    } catch (const Broken& broken) {
      encoded.failure = broken.what();
    } catch (const std::bad_alloc&) {
      encoded.failure = "there is not enough memory for it";
    }
  Bytes().swap(encoded.own);
  if (encoded.failure.empty()) return;
  for (const int index : job.textures) fill_placeholder(scene.textures[static_cast<size_t>(index)]);
}

std::string name_of(const Document& document, int image) {
  if (image < 0) return "no image";
  const Source& source = document.images[static_cast<size_t>(image)];
  if (!source.name.empty()) return source.name;
  return source.uri.empty() || is_data_uri(source.uri) ? fmt::format("image {}", image) : clean_name(source.uri);
}

}  // namespace

void fill_placeholder(Texture& texture) {
  constexpr int kSide = 8;
  texture.size = {kSide, kSide};
  texture.rgba.clear(), texture.rgba16.clear();
  for (int i = 0; i < kSide * kSide; ++i) {
    const bool magenta = (i / kSide + i % kSide) % 2 == 0;
    for (const uint8_t channel : {magenta ? 255 : 0, 0, magenta ? 255 : 0, 255}) texture.rgba.push_back(channel);
  }
}

void decode_images(const Document& document, std::vector<ImageJob> jobs, Scene& scene, Folder& folder, Job& job) {
  std::vector<Encoded> encoded;
  uint64_t texture_bytes = 0;
  for (const ImageJob& one : jobs) {
    encoded.push_back(open_image(document, one.image, texture_bytes, one.textures.size(), folder));
    // A view into `own` stays true when the vector grows: moving a vector keeps its bytes where they are.
    for (const int texture : one.textures)
      scene.textures[static_cast<size_t>(texture)].name = name_of(document, one.image);
  }
  std::atomic<size_t> next{0}, done{0};
  const auto work = [&](int helper) {
    for (size_t i = next++; i < jobs.size() && !job.cancelled(); i = next++) {
      fill(scene, jobs[i], encoded[i]);
      ++done;
      if (helper == 0 && !job.cancelled())  // on the caller's thread
        job.step("textures", 0.6 + 0.39 * static_cast<double>(done) / static_cast<double>(jobs.size()));
    }
  };
  on_threads(std::min(all_processors(), static_cast<int>(jobs.size())), work);
  job.step("textures", 0.99);
  for (size_t i = 0; i < jobs.size(); ++i)
    if (!encoded[i].failure.empty())
      job.note(fmt::format("image '{}': {}; shown as a magenta checker", name_of(document, jobs[i].image),
                           encoded[i].failure));
}

}  // namespace gbl::gltf
