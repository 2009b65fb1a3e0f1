#include "renderer/picture/exr_header.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "renderer/base/error.h"

namespace gbl {
namespace {

struct FixedType {
  std::string_view name;
  size_t bytes;
};
constexpr FixedType kFixedTypes[] = {{"box2i", 16},
                                     {"box2f", 16},
                                     {"chromaticities", 32},
                                     {"compression", 1},
                                     {"deepImageState", 1},
                                     {"double", 8},
                                     {"envmap", 1},
                                     {"float", 4},
                                     {"int", 4},
                                     {"keycode", 28},
                                     {"lineOrder", 1},
                                     {"m33d", 72},
                                     {"m33f", 36},
                                     {"m44d", 128},
                                     {"m44f", 64},
                                     {"rational", 8},
                                     {"tiledesc", 9},
                                     {"timecode", 8},
                                     {"v2d", 16},
                                     {"v2f", 8},
                                     {"v2i", 8},
                                     {"v3d", 24},
                                     {"v3f", 12},
                                     {"v3i", 12}};

class Bytes {
 public:
  explicit Bytes(std::string_view left) : left_(left) {}
  std::string_view take(size_t count) {
    if (count > left_.size()) short_ = true, count = left_.size();
    const std::string_view out = left_.substr(0, count);
    left_.remove_prefix(count);
    return out;
  }
  std::string_view text() {  // up to its end
    const std::string_view out = take(std::min(left_.find('\0'), left_.size()));
    take(1);
    return out;
  }
  size_t number() {
    size_t out = 0;
    const std::string_view four = take(4);
    for (size_t i = 0; i < four.size(); ++i) out |= size_t{static_cast<uint8_t>(four[i])} << (8 * i);
    return out;
  }
  size_t left() const { return left_.size(); }
  bool ran_short() const { return short_; }

 private:
  std::string_view left_;
  bool short_ = false;
};

// Channels end with an empty name, and nothing follows them.
bool is_channel_list(std::string_view value) {
  constexpr size_t kOfAChannel = 16;
  Bytes bytes(value);
  while (!bytes.text().empty()) bytes.take(kOfAChannel);
  return !bytes.ran_short() && bytes.left() == 0;
}

bool is_preview(std::string_view value) {
  Bytes bytes(value);
  const size_t width = bytes.number(), height = bytes.number();
  return !bytes.ran_short() && width <= value.size() && height <= value.size() && bytes.left() == 4 * width * height;
}

bool is_of_type(std::string_view type, std::string_view value) {
  if (type == "chlist") return is_channel_list(value);
  if (type == "preview") return is_preview(value);
  const auto* fixed =
      std::find_if(std::begin(kFixedTypes), std::end(kFixedTypes), [&](const FixedType& t) { return t.name == type; });
  return fixed == std::end(kFixedTypes) || fixed->bytes == value.size();
}

}  // namespace

void require_sound_exr_header(std::string_view start, size_t file_bytes, const std::string& where) {
  Bytes bytes(start);
  bytes.take(8);
  while (bytes.left() > 0) {
    const std::string_view name = bytes.text();
    if (name.empty()) return;
    const std::string_view type = bytes.text();
    const size_t length = bytes.number();
    if (bytes.ran_short() || length > file_bytes || !is_of_type(type, bytes.take(length)))
      throw Error(ExitCode::bad_input, where, "its header is cut short or damaged",
                  "give an OpenEXR file with channels R, G and B");
  }
}

}  // namespace gbl
