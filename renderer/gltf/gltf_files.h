#pragma once
// The bytes a glTF file refers to: data URIs and files below the model's folder.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gbl::gltf {

using Bytes = std::vector<uint8_t>;

bool is_data_uri(std::string_view uri);
Bytes decode_data_uri(std::string_view uri);        // base64 or percent-encoded; Broken
std::string percent_decoded(std::string_view uri);  // RFC 3986, section 2.1; Broken

// A model's folder; an empty path allows no file at all.
class Folder {
 public:
  explicit Folder(const std::filesystem::path& folder = {});
  // Broken unless the URI is a relative path to a regular file that lies in the folder after all links are followed.
  Bytes read(std::string_view uri);

 private:
  std::filesystem::path folder_;
  uint64_t bytes_read_ = 0;
};

Bytes read_file(const std::filesystem::path&, uint64_t limit);  // Broken

}  // namespace gbl::gltf
