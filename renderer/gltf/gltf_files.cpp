#include "renderer/gltf/gltf_files.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>

#include "renderer/gltf/gltf_job.h"
#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// RFC 4648, section 4; the URL alphabet of section 5 is taken as well. -1: no digit.
constexpr std::array<int, 256> base64_digits() {
  std::array<int, 256> digit{};
  for (auto& d : digit) d = -1;
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < kAlphabet.size(); ++i) digit[static_cast<uint8_t>(kAlphabet[i])] = static_cast<int>(i);
  digit['-'] = 62;
  digit['_'] = 63;
  return digit;
}

Bytes decode_base64(std::string_view text) {
  static constexpr auto kDigits = base64_digits();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = kDigits[static_cast<uint8_t>(c)];
    if (digit < 0) throw Broken("its data URI is not base64");
    bits = bits << 6 | static_cast<uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<uint8_t>(bits >> held));
  }
  return bytes;
}

// A scheme is letters before the first colon (RFC 3986, section 3.1); "C:" is a Windows drive.
bool has_scheme(std::string_view uri) {
  const size_t colon = uri.find(':');
  return colon != std::string_view::npos && uri.find('/') > colon;
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  const auto [rest, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return rest == folder.end();
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.substr(0, 5) == "data:"; }

std::string percent_decoded(std::string_view uri) {
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
    out += coded ? static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  if (out.find('\0') != std::string::npos) throw Broken("its URI holds a zero byte");
  return out;
}

Bytes decode_data_uri(std::string_view uri) {
  const size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw Broken("its data URI has no comma");
  const std::string_view head = uri.substr(0, comma), body = uri.substr(comma + 1);
  if (head.size() >= 7 && head.substr(head.size() - 7) == ";base64") return decode_base64(body);
  const std::string text = percent_decoded(body);
  return Bytes(text.begin(), text.end());
}

Folder::Folder(const fs::path& folder) {
  std::error_code error;
  if (!folder.empty()) folder_ = fs::canonical(folder, error);
}

Bytes Folder::read(std::string_view uri) {
  const std::string shown = clean_name(uri);
  if (folder_.empty()) throw Broken(fmt::format("'{}' is another file, and only this one is read", shown));
  if (has_scheme(uri)) throw Broken(fmt::format("'{}' is not a file in the model's folder", shown));
  const std::string name = percent_decoded(uri);
  const fs::path relative = name;
  const bool upward = std::any_of(relative.begin(), relative.end(), [](const fs::path& part) { return part == ".."; });
  if (name.empty() || relative.is_absolute() || upward || name.find('\\') != std::string::npos)
    throw Broken(fmt::format("'{}' is not a file in the model's folder", shown));
  std::error_code error;
  const fs::path file = fs::canonical(folder_ / relative, error);
  if (error) throw Broken(fmt::format("the file '{}' cannot be opened", shown));
  if (!lies_in(file, folder_)) throw Broken(fmt::format("'{}' leads out of the model's folder", shown));
  Bytes bytes = read_file(file, std::min(kMaxFileBytes, kMaxAllFileBytes - bytes_read_));
  bytes_read_ += bytes.size();
  return bytes;
}

Bytes read_file(const fs::path& path, uint64_t limit) {
  const std::string shown = clean_name(path.filename().string());
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw Broken(fmt::format("'{}' is not a file", shown));
  const uint64_t size = fs::file_size(path, error);
  if (error) throw Broken(fmt::format("the file '{}' cannot be read", shown));
  if (size > limit) throw Broken(fmt::format("the file '{}' has {} bytes, at most {} are read", shown, size, limit));
  std::ifstream in(path, std::ios::binary);
  Bytes bytes(size);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    throw Broken(fmt::format("the file '{}' cannot be read", shown));
  return bytes;
}

}  // namespace gbl::gltf
