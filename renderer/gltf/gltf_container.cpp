#include "renderer/gltf/gltf_container.h"

#include <fmt/format.h>

#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {
namespace {

constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;  // "JSON", "BIN\0"
constexpr const char* kCopyAgain = "copy or export the file again";

// Little-endian on every machine. (Specification 4.2)
uint32_t word(std::span<const uint8_t> bytes, size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | static_cast<uint32_t>(bytes[at + 3]) << 24;
}

Container open_glb(std::span<const uint8_t> bytes, const Job& job) {
  if (bytes.size() < kHeaderBytes) job.refuse("the file ends in its header", kCopyAgain);
  const uint32_t version = word(bytes, 4), length = word(bytes, 8);
  if (version != 2) job.refuse(fmt::format("binary glTF of version {}", version), "export it as glTF 2.0");
  if (length > bytes.size())
    job.refuse(fmt::format("the file should have {} bytes, but ends after {}", length, bytes.size()), kCopyAgain);
  Container found;
  size_t at = kHeaderBytes;
  for (int chunk = 0; length - at >= kChunkHeaderBytes && length >= at; ++chunk) {
    const uint32_t size = word(bytes, at), type = word(bytes, at + 4);
    at += kChunkHeaderBytes;
    if (size > length - at)
      job.refuse(fmt::format("chunk {} should have {} bytes, but only {} follow", chunk, size, length - at),
                 kCopyAgain);
    const auto body = bytes.subspan(at, size);
    if (chunk == 0 && type != kJsonChunk) job.refuse("the first chunk is not JSON", kCopyAgain);
    if (chunk == 0) found.json = {reinterpret_cast<const char*>(body.data()), body.size()};
    if (chunk == 1 && type == kBinaryChunk) found.binary = body, found.has_binary = true;
    at += size;
    if (chunk >= 1) break;  // further chunks are extensions', to be ignored (specification 4.4.1)
  }
  if (found.json.empty()) job.refuse("there is no JSON chunk", kCopyAgain);
  return found;
}

}  // namespace

Container open_container(std::span<const uint8_t> bytes, const Job& job) {
  if (bytes.empty()) job.refuse("the file is empty", kCopyAgain);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.substr(0, 4) == "glTF") return open_glb(bytes, job);
  const size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");  // a byte order mark may stand before
  if (first == std::string_view::npos || text[first] != '{')
    job.refuse("neither glTF JSON ('{') nor binary glTF ('glTF') at the start", "give a .gltf or .glb file");
  return {text.substr(first), {}, false};
}

void check_json_shape(std::string_view json, const Job& job) {
  uint64_t depth = 0, values = 1;
  bool in_text = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text) {
      if (c == '\\') ++i;
      if (c == '"') in_text = false;
      continue;
    }
    if (c == '"') in_text = true;
    if (c == '[' || c == '{') ++depth, ++values;
    if (c == ',' || c == ':') ++values;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (depth > kMaxJsonDepth)
      job.refuse(fmt::format("JSON nested deeper than {} at byte {}", kMaxJsonDepth, i), "export the model again");
    if (values > kMaxJsonValues) job.refuse_limit("or more JSON values", values, kMaxJsonValues);
  }
}

}  // namespace gbl::gltf
